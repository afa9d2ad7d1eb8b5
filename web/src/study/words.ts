/** Every text of the study for people, in the language that is spoken. Where numbers or names stand, a function takes them. */
import { say } from "../language/say.ts";

export const words = {
  get title() {
    return say("Study");
  },
  why: {
    get title() {
      return say("See why");
    },
    get along() {
      return say("Along the axis");
    },
    get place() {
      return say("Place along the axis");
    },
    get hint() {
      return say("Rest the pointer on the plant, or move along these plots: both show the same place.");
    },
    quantity: {
      get angle() {
        return say("Angle above the horizontal");
      },
      get curvature() {
        return say("Curvature");
      },
      get moment() {
        return say("Bending moment");
      },
      get stress() {
        return say("Largest stress");
      },
    },
    get distance() {
      return say("Distance along the axis");
    },
    get asTable() {
      return say("As a table");
    },
    get saveDrawing() {
      return say("Save as SVG");
    },
    get saveNumbers() {
      return say("Save as CSV");
    },
    get tip() {
      return say("What moves the tip most");
    },
    get tipNote() {
      return say("By how much the tip would move, from the exact derivatives of the whole growth.");
    },
    more: (label: string, change: string) => say("{0}, {1} more", label, change),
    share: "10 %",
    turn: "5°",
    moves: (distance: string, where: string) => `${distance} ${where}`,
    get up() {
      return say("up");
    },
    get down() {
      return say("down");
    },
    get left() {
      return say("to the left");
    },
    get right() {
      return say("to the right");
    },
    get nowhere() {
      return say("nowhere");
    },
    none: {
      get forces() {
        return say("A plant that is pulled at has none: let go of it.");
      },
      get extrapolated() {
        return say("Extrapolated growth has no exact derivatives: choose exact or static stepping.");
      },
      get plant() {
        return say(
          "There are none for this plant: it is too large, did not come to rest, or leaves the plane of the picture.",
        );
      },
    },
    noSlope: (labels: string) => say("The tip does not depend smoothly on: {0}.", labels),
    failed: (reason: string) => say("This could not be computed. {0}", reason),
    get computing() {
      return say("Computing…");
    },
    get ways() {
      return say("Two ways to rest");
    },
    get waysNote() {
      return say(
        "The way to rest as the paper computes it, by damped Euler steps, beside Newton’s method, which Bough uses. Both play in the same time here; in truth an iteration of Newton’s takes about as long as a few Euler steps.",
      );
    },
    get from() {
      return say("From where");
    },
    get step() {
      return say("The last growth step");
    },
    get whole() {
      return say("All the weight at once, from the unloaded shape");
    },
    get wholeNote() {
      return say("At once the wood remembers nothing of its growth: both end where static stepping does.");
    },
    get play() {
      return say("Play both");
    },
    get again() {
      return say("Play again");
    },
    get pause() {
      return say("Pause");
    },
    get stop() {
      return say("Stop");
    },
    get close() {
      return say("Close");
    },
    get moment() {
      return say("Moment");
    },
    euler: (step: string, of: string) => say("Euler step {0} of {1}", step, of),
    newton: (iteration: string, of: string) => say("Newton’s iteration {0} of {1}", iteration, of),
    leftOver: (share: string) => say("{0} of the largest torque left over", share),
    led: (iterations: number) =>
      say(
        "From here Newton’s steps are not trusted: Bough raised the load in parts, {0} iterations in all.",
        iterations,
      ),
    get notThere() {
      return say("Euler’s method did not come to rest within two million steps.");
    },
    get residual() {
      return say("Torque left over (share of the largest)");
    },
    get work() {
      return say("Euler steps, or iterations of Newton’s method");
    },
    get holds() {
      return say("Does it hold?");
    },
    get stable() {
      return say("Stable, at every age so far.");
    },
    get unstableNow() {
      return say("Unstable: the least push would tip it over.");
    },
    unstableSince: (step: number) =>
      say(
        "It could not have stood like this from growth step {0} on: there it was unstable, and a real plant would have tipped over one way or the other.",
        step,
      ),
    get noEquilibrium() {
      return say("Not in equilibrium, so nothing can be said.");
    },
    stands: (share: string) =>
      say("Its loads are {0} of those at which it could no longer stand straight.", share),
    leans: (share: string) =>
      say("Its loads are {0} of those at which it can no longer stand straight: it has leaned over.", share),
    buckling: (q: string, critical: string, share: string) =>
      say(
        "An upright axis of even thickness buckles under its own weight at a gravity number of {1} (Greenhill 1881). This one has {0}: {2}.",
        q,
        critical,
        share,
      ),
    ofCritical: (share: string) => say("{0} of that", share),
    stressAt: (stress: string, distance: string) =>
      say("Largest stress {0}, {1} along its axis.", stress, distance),
    safety: (factor: string) => say("The wood would bear {0} times that before it breaks.", factor),
    breaks: (factor: string) =>
      say("That is more than the wood bears: it would break (safety factor {0}).", factor),
    get stability() {
      return say("Stability");
    },
    get strength() {
      return say("Strength");
    },
  },
  compare: {
    get title() {
      return say("Compare");
    },
    get note() {
      return say("Pin the plant as it is now: it stays as a dashed line, A, while you change things.");
    },
    get pin() {
      return say("Pin this plant as A");
    },
    get pinAgain() {
      return say("Pin this one instead");
    },
    get unpin() {
      return say("Take A away");
    },
    get swap() {
      return say("Swap A and the present one");
    },
    get caption() {
      return say("A, the present plant, and the difference");
    },
    get measure() {
      return say("Measure");
    },
    a: "A",
    get now() {
      return say("Now");
    },
    get difference() {
      return say("Difference");
    },
    rows: {
      get length() {
        return say("Length");
      },
      get across() {
        return say("Tip across");
      },
      get up() {
        return say("Tip up");
      },
      get pointing() {
        return say("Tip points");
      },
      get gravityNumber() {
        return say("Gravity number");
      },
      get moment() {
        return say("Largest moment");
      },
      get stress() {
        return say("Largest stress");
      },
      get steps() {
        return say("Growth steps");
      },
    },
    get changed() {
      return say("What is different");
    },
    get same() {
      return say("Nothing: both are the same plant.");
    },
    changes: (label: string, a: string, now: string) => say("{0}: {1}, now {2}", label, a, now),
    moved: (unit: string) => say("How far each place is from where it is in A ({0})", unit),
    get turned() {
      return say("How far it is turned from A (°)");
    },
    get share() {
      return say("Distance along the axis (% of its length)");
    },
    get unreadable() {
      return say("The pinned plant of the link cannot be grown, so nothing is pinned.");
    },
    get growing() {
      return say("Growing the pinned plant of the link…");
    },
  },
  measure: {
    get title() {
      return say("Measure and fit");
    },
    get tools() {
      return say("Ruler and protractor");
    },
    get ruler() {
      return say("Ruler");
    },
    get protractor() {
      return say("Protractor");
    },
    get toolsNote() {
      return say("Drag their handles, or move them with the arrow keys (with Shift ten times as far).");
    },
    get inSpace() {
      return say("Lengths and angles are true only in the plane view.");
    },
    get toPlane() {
      return say("Look at the plane");
    },
    get aroundStem() {
      return say("Around a stem every axis grows in a plane of its own: trace a single one.");
    },
    rulerHandle: (end: number, place: string) => say("Ruler, end {0}: {1}", end, place),
    protractorHandle: (part: string, place: string) => say("Protractor, {0}: {1}", part, place),
    get corner() {
      return say("corner");
    },
    arm: (arm: number) => say("arm {0}", arm),
    place: (across: string, up: string) => say("{0} across, {1} up", across, up),
    length: (length: string, direction: string) => say("Ruler: {0}, {1}.", length, direction),
    angle: (angle: string) => say("Protractor: {0} between its arms.", angle),
    get photo() {
      return say("Photo");
    },
    get photoNote() {
      return say("Choose a photo of a branch, drop it on the picture, or paste it. It stays on this device.");
    },
    get choose() {
      return say("Choose a photo…");
    },
    get remove() {
      return say("Remove the photo");
    },
    get opacity() {
      return say("Opacity");
    },
    get turn() {
      return say("Turn");
    },
    get click() {
      return say("What a click on the picture does");
    },
    modes: {
      get pull() {
        return say("Pulls at the plant");
      },
      get move() {
        return say("Moves the photo");
      },
      get base() {
        return say("Says where the base is on the photo");
      },
      get scale() {
        return say("Measures a known length on the photo");
      },
      get trace() {
        return say("Traces the branch");
      },
    },
    get baseNote() {
      return say("Click on the photo where the axis leaves its base: it is moved there.");
    },
    get scaleNote() {
      return say("Click on both ends of something of known length, and say how long it is.");
    },
    get known() {
      return say("Known length (m)");
    },
    get setScale() {
      return say("Set the scale");
    },
    get badLength() {
      return say("The length must be a number above 0, in metres.");
    },
    get traceNote() {
      return say(
        "Click along the middle of the branch, from the base to the tip. Points can be dragged, and taken away with Delete.",
      );
    },
    points: (count: number) => (count === 1 ? say("1 point") : say("{0} points", count)),
    get add() {
      return say("Add a point");
    },
    get undo() {
      return say("Take the last one away");
    },
    get clear() {
      return say("Take all away");
    },
    point: (index: number, place: string) => say("Traced point {0}: {1}", index, place),
    get lastIsTip() {
      return say("The last point is the tip");
    },
    get fit() {
      return say("Fit");
    },
    get fitNote() {
      return say("Which values would bring the axis to the traced line? All others stay as they are.");
    },
    get which() {
      return say("Values to fit");
    },
    get run() {
      return say("Fit to the line");
    },
    get fitting() {
      return say("Fitting…");
    },
    get stop() {
      return say("Stop");
    },
    get value() {
      return say("Value");
    },
    get fitted() {
      return say("Fitted");
    },
    get interval() {
      return say("95 % interval");
    },
    between: (low: string, high: string) => say("{0} to {1}", low, high),
    get caption() {
      return say("Fitted values");
    },
    deviation: (distance: string, count: string) =>
      say(
        "Within {0} of the traced line (root mean square), after {1}. The plant has these values now; Undo brings the old ones back.",
        distance,
        count,
      ),
    iterations: (count: number) => (count === 1 ? say("1 iteration") : say("{0} iterations", count)),
    get sure() {
      return say(
        "Of 100 such tracings, 95 would have the true value within their interval, if the model and all other values are right.",
      );
    },
    get none() {
      return say("Choose at least one value to fit.");
    },
    tooFew: (least: number) => say("Trace at least {0} points for that.", least),
    unseen: (labels: string) => say("The traced line says nothing about: {0}.", labels),
    inseparable: (labels: string) =>
      say(
        "These cannot be told apart by the line, only a combination of them: {0}. Fit fewer of them.",
        labels,
      ),
    get lost() {
      return say(
        "No plant with derivatives comes to rest there: let go of the plant, choose exact or static stepping, or start from milder values.",
      );
    },
    failed: (reason: string) => say("The fit broke off. {0}", reason),
    notAnImage: (name: string) =>
      say("{0} is not a photo that can be shown here: PNG, JPEG, WebP, GIF, AVIF and BMP can.", name),
    tooLarge: (name: string, size: string) =>
      say("{0} has {1}; photos of up to 64 MB can be shown.", name, size),
    unreadable: (name: string) =>
      say("{0} cannot be read as a picture: it is damaged, or too large for this browser.", name),
  },
} as const;
