/** The page in German: what parameters, presets and errors say. */
import type { Dictionary } from "./dictionary.ts";

export const declared: Omit<Dictionary, "texts"> = {
  parameters: {
    "axis.segments": [
      "Segmente",
      "Zu wie vielen Segmenten eine Achse heranwächst; die Hauptachse gewinnt in jedem Wachstumsschritt eines.",
    ],
    "axis.segmentLength": ["Segmentlänge", "Mittlere Länge eines Segments."],
    "axis.lengthProfile": [
      "Längenprofil",
      "Länge der mittleren Segmente im Verhältnis zu denen an den Enden: 1 macht alle gleich, mehr macht die mittleren länger.",
    ],
    "axis.radius": [
      "Radius",
      "Radius eines neu gebildeten Segments (einer Röhre); mit Verjüngung der Radius an der Basis.",
    ],
    "axis.taper": [
      "Verjüngung",
      "Radius an der Spitze im Verhältnis zum Radius an der Basis, linear entlang der fertigen Achse: 1 ist gleichmäßig, 0 ein Kegel. Ohne Wirkung, wenn das Holz durch Röhren dicker wird: Die ergeben ihre eigene Verjüngung.",
    ],
    "axis.elevation": [
      "Elevation",
      "Richtung, in der die Achse ihre Basis verlässt, über der Waagrechten; negativ zeigt nach unten.",
    ],
    "axis.azimuth": [
      "Azimut",
      "Himmelsrichtung der senkrechten Ebene der Achse: ihre Drehung um die Senkrechte, von oben gesehen gegen den Uhrzeigersinn.",
    ],
    "axis.restCurvature": [
      "Angelegte Krümmung",
      "Biegung jungen Holzes vor jeder Last: die Krümmung, die es im freien Fall behielte; positiv biegt zur Oberseite.",
    ],
    "axis.restCurvatureRoll": [
      "Drehung der angelegten Krümmung",
      "Richtung um die Achse, nach der junges Holz gebogen ist: 0 ist die Oberseite, 90 die Seite, die rechts liegt, wenn man die Achse entlangblickt.",
    ],
    "axis.restTwist": [
      "Angelegte Verdrehung",
      "Verdrehung jungen Holzes in Radiant je Meter, wie bei Drehwuchs: Mit einer angelegten Krümmung wächst die Achse zu einer Schraube mit Radius c/(c^2 + t^2) und Ganghöhe 2 pi t/(c^2 + t^2).",
    ],
    "material.youngsModulus": [
      "Elastizitätsmodul",
      "Steifigkeit des Holzes gegen Biegung: Frisches Holz hat 1 bis 15 GPa, weiche Triebe ein Hundertstel davon.",
    ],
    "material.density": ["Dichte", "Masse des Holzes je Volumen; frisches Holz kommt Wasser nahe."],
    "material.shearModulusRatio": [
      "Schubmodulverhältnis",
      "Schubmodul durch Elastizitätsmodul, widersteht der Verdrehung: GJ/EI eines runden Querschnitts ist das Doppelte davon. Holz hat etwa 0,06 bis 0,12, Gummi 0,33.",
    ],
    "material.modulusOfRupture": [
      "Bruchfestigkeit",
      "Randfaserspannung, bei der das Holz bricht: Frisches Holz hält 30 bis 80 MPa stand, weiche Triebe einem Zehntel davon.",
    ],
    "tropism.elevation": [
      "Vorzugsrichtung",
      "Die Richtung, in der die Achse wachsen will, über der Waagrechten: 90 ist senkrecht nach oben, 0 waagrecht, -90 senkrecht nach unten.",
    ],
    "tropism.azimuth": [
      "Azimut der Vorzugsrichtung",
      "Himmelsrichtung des Gesuchten, für alle Achsen dieselbe, wie Licht von einer Seite; ohne sie sucht jede Achse in ihrer eigenen senkrechten Ebene.",
    ],
    "tropism.strength": [
      "Stärke des Tropismus",
      "Wie rasch sich junges Holz der Vorzugsrichtung zuwendet, je Meter Wachstum: 0 ist gar nicht, ab 1e6 vollständig. Junges Holz, das genau von der Vorzugsrichtung weg zeigt, hat keine Seite, nach der es sich wenden könnte, und behält seine Richtung.",
    ],
    "growth.thickening": [
      "Dickenwachstum",
      "Ob älteres Holz dicker wird: Mit Röhren gewinnt jedes ältere Segment in jedem Wachstumsschritt eine Röhre gleicher Fläche, spannungsfrei angelegt.",
    ],
    "branching.pattern": [
      "Verzweigung",
      "Ob eine ausgewachsene Achse in einer Gabelung endet: Bei Gabelung in zwei ungleich dicken Trieben, die neue Achsen sind.",
    ],
    "branching.generations": ["Generationen", "Wie oft sich jeder Weg gabelt."],
    "branching.lengthRatio": [
      "Längenverhältnis",
      "Segmente einer Tochterachse im Verhältnis zu denen ihrer Mutterachse, gerundet, mindestens eines.",
    ],
    "branching.exponent": [
      "Murray-Exponent",
      "Exponent der Dicken an einer Gabelung: 2 erhält die Fläche (da Vinci), und beide Triebe laufen geradeaus; 2,49 ist der Wert der Veröffentlichung, 3 Murrays Gesetz für Gefäße; größere Werte spreizen die Triebe weiter.",
    ],
    "branching.girthRatio": [
      "Dickenverhältnis",
      "Dicke des dünneren Triebs im Verhältnis zu der des dickeren; der dünnere wendet sich weiter ab.",
    ],
    "branching.roll": [
      "Drehung der Gabelungen",
      "Drehung der Ebene jeder Gabelung um ihre Mutterachse, gezählt von der Ebene der Gabelung davor: Bei 0 liegen alle in einer Ebene, und der dickere Trieb wendet sich gegen den Uhrzeigersinn, bei 90 stehen Gabelungen über Kreuz; darüber tauschen die Triebe die Seiten, sodass 180 das Spiegelbild von 0 ist.",
    ],
    "arrangement.pattern": [
      "Anordnung",
      "Eine Pflanze; oder Kopien von ihr um einen geraden, starren Stamm, jede in ihrer eigenen senkrechten Ebene, die unteren älter; oder Achsen an einem Stamm, der selbst wächst und sich unter ihnen biegt und verdreht.",
    ],
    "arrangement.count": [
      "Achsen am Stamm",
      "Wie viele Achsen der Stamm trägt, wenn alle zu wachsen begonnen haben.",
    ],
    "arrangement.spacing": ["Abstand am Stamm", "Stammlänge zwischen einer Achse und der nächsten."],
    "arrangement.trunk": [
      "Kahler Stamm",
      "Länge des kahlen Stamms unten; darüber beginnt der erste Abstand.",
    ],
    "arrangement.divergence": [
      "Divergenzwinkel",
      "Drehung um den Stamm von einer Achse zur nächsten; 137,5 ist der goldene Winkel der spiraligen Blattstellung, 180 ergibt zwei Zeilen.",
    ],
    "arrangement.interval": [
      "Abstand in Schritten",
      "Wachstumsschritte vom Beginn einer Achse bis zum Beginn der nächsten über ihr; eine Achse, deren Zeit nicht gekommen ist, gibt es noch nicht.",
    ],
    "arrangement.stemRadius": [
      "Radius des Stamms",
      "Radius eines neu gebildeten Segments eines biegsamen Stamms (einer Röhre); ein starrer Stamm ist so dick, wie die Achsen über ihm es brauchen.",
    ],
    "arrangement.stemElevation": [
      "Elevation des Stamms",
      "Richtung, in der ein biegsamer Stamm den Boden verlässt, über der Waagrechten; seine Achsen neigen sich mit.",
    ],
    "loads.gravity": [
      "Schwerkraft",
      "Fallbeschleunigung: 9,81 auf der Erde, 1,62 auf dem Mond, 0 im freien Fall.",
    ],
    "loads.tipMass": [
      "Masse an der Spitze",
      "Eine Frucht oder Blüte an jeder Spitze, getragen vom ersten Wachstumsschritt an.",
    ],
    "loads.foliage": [
      "Laub",
      "Masse der Blätter je Meter jungen Holzes, in jedem Wachstumsschritt getragen.",
    ],
    "loads.foliageAge": [
      "Alter des Laubs",
      "Wie viele Wachstumsschritte lang ein Segment Blätter trägt: Das gilt als junges Holz.",
    ],
    "loads.foliageArea": [
      "Fläche des Laubs",
      "Fläche der Blätter, einer Seite, je Masse: was Wind und Schnee trifft. Frische Laubblätter haben 3 bis 6, Nadeln 1 bis 2.",
    ],
    "loads.snow": [
      "Schnee oder Regen",
      "Masse, die auf der ausgewachsenen Pflanze liegt, je Fläche ihres Holzes von oben gesehen und ihrer Blätter: 0,2 bei Regen, 5 bis 40 bei Schnee.",
    ],
    "loads.wind": [
      "Wind",
      "Geschwindigkeit eines stetigen Windes auf die ausgewachsene Pflanze. Holz drückt er quer zu dessen Richtung, mit dem Quadrat der Geschwindigkeit, die es im rechten Winkel trifft, Blätter in seine eigene Richtung.",
    ],
    "loads.windAzimuth": [
      "Windrichtung",
      "Wohin der Wind weht, um die Senkrechte gedreht: 0 ist nach rechts, 180 nach links.",
    ],
    "loads.dragCoefficient": [
      "Widerstand des Holzes",
      "Widerstandsbeiwert des Holzes, bezogen auf seinen Durchmesser; ein runder Stab hat etwa 1.",
    ],
    "loads.foliageDrag": [
      "Widerstand des Laubs",
      "Widerstandsbeiwert der Blätter, bezogen auf ihre Fläche in ruhiger Luft; im Wind falten sie sich, daher liegt er weit unter dem einer Platte.",
    ],
    "loads.tipForce": [
      "Kraft an der Spitze",
      "Eine Kraft x, y, z auf die Spitze der Hauptachse; sie wirkt in jedem Wachstumsschritt auf die Spitze dieses Alters. An einem Stamm zeigt x von ihm weg.",
    ],
    "loads.forces": [
      "Kräfte auf Segmente",
      "Kräfte, die nach dem Wachstum am fernen Ende von Segmenten ziehen, wie ein Zeiger es tut: eine Liste aus {segment, force: [x, y, z]}. In Links steht sie nicht.",
    ],
    "loads.picked": [
      "Früchte pflücken",
      "Nach dem Wachstum die Massen an den Spitzen abnehmen und zeigen, wie weit sich die Pflanze wieder hebt.",
    ],
    "loads.removed": [
      "Lasten abnehmen",
      "Nach dem Wachstum alle Lasten abnehmen und zeigen, was gebogen bleibt: die Form, an die sich das Holz erinnert.",
    ],
    "solver.discretization": [
      "Diskretisierung",
      "Wie der stetige Stab zerlegt wird: Der Weg der Veröffentlichung ist erster Ordnung, der andere zweiter, sodass wenige Segmente genügen.",
    ],
    "solver.method": [
      "Verfahren",
      "Wie das Gleichgewicht gefunden wird: mit Newtons Verfahren und der exakten Hesse-Matrix, oder mit der gedämpften Euler-Relaxation der Veröffentlichung, die viel langsamer ist.",
    ],
    "solver.tolerance": [
      "Toleranz",
      "Größtes Drehmoment, das an einem Gelenk übrig bleiben darf, im Verhältnis zum größten Drehmoment in der Pflanze.",
    ],
    "solver.stepping": [
      "Schrittweise",
      "„Exakt“ bringt jeden Wachstumsschritt ins Gleichgewicht; „statisch“ löst die fertige Pflanze auf einmal, mit von null an steigenden Lasten, ohne Erinnerung an ihr Wachstum; „extrapoliert“ sieht diese Erinnerung aus gröberen Zerlegungen einer gleichmäßig zerlegten einzelnen Achse voraus und sagt, wie weit das daneben liegen kann (andere Pflanzen wachsen exakt).",
    ],
    "solver.space": [
      "Immer im Raum",
      "Berechnet auch Pflanzen, die in einer senkrechten Ebene liegen, mit Stäben im Raum: dieselbe Form, langsamer. Alle anderen werden ohnehin so berechnet.",
    ],
  },
  presets: {
    "figure-2a": [
      "Senkrecht nach oben",
      "Negativer Orthogravitropismus: Wo das Organ auch beginnt, es wendet sich, bis es senkrecht nach oben wächst.",
    ],
    "figure-2b": [
      "Schräg nach oben",
      "Negativer Plagiogravitropismus: Das Organ stellt sich auf einen Winkel über der Waagrechten ein, wie viele Äste.",
    ],
    "figure-2c": ["Waagrecht", "Diagravitropismus: Das Organ wächst waagrecht, wie Ausläufer und Rhizome."],
    "figure-2d": [
      "Schräg nach unten",
      "Positiver Plagiogravitropismus: Das Organ stellt sich auf einen Winkel unter der Waagrechten ein, wie Seitenwurzeln.",
    ],
    "figure-2e": [
      "Senkrecht nach unten",
      "Positiver Orthogravitropismus: Das Organ wendet sich, bis es senkrecht nach unten wächst, wie eine Hauptwurzel.",
    ],
    "figure-8a": [
      "Eine Achse unter Schwerkraft, jung",
      "Eine kurze Achse spürt ihr Gewicht kaum: Sie verlässt die Basis unter 50 Grad und bleibt fast gerade.",
    ],
    "figure-8b": [
      "Eine Achse unter Schwerkraft, im Wachsen",
      "Doppelte Länge ist die achtfache Schwerezahl (Länge hoch drei): Die Spitze beginnt sich zu neigen.",
    ],
    "figure-8c": [
      "Eine Achse unter Schwerkraft, im Bogen",
      "Nun bildet die ganze Achse einen Bogen, und ihre Spitze zeigt unter die Waagrechte.",
    ],
    "figure-8d": [
      "Eine Achse unter Schwerkraft, ausgewachsen",
      "Die Spitze hängt herab: dasselbe Holz, nur länger. Die Biegung wächst mit der dritten Potenz der Länge.",
    ],
    "figure-10": [
      "Derselbe Stab, ungleich zerlegt",
      "Kurze Segmente an den Enden und lange in der Mitte ergeben (fast) die Form von Abbildung 8: Auf die Zerlegung kommt es nicht an.",
    ],
    "figure-13a": [
      "Ein Tropismus gegen die Schwerkraft, jung",
      "Junges Holz beginnt immer unter 45 Grad; eine kurze Achse kann es dort halten.",
    ],
    "figure-13b": [
      "Ein Tropismus gegen die Schwerkraft, im Wachsen",
      "Altes Holz sackt unter dem, was es trägt, während die Spitze noch 45 Grad sucht: Ein S beginnt.",
    ],
    "figure-13c": [
      "Ein Tropismus gegen die Schwerkraft, ausgewachsen",
      "Die S-Form vieler Äste: Der alte Teil sackt ab, der junge richtet sich auf. Es gibt einen Wendepunkt.",
    ],
    "figure-13d": [
      "Suchende Achsen um einen Stamm",
      "Die Achse von Abbildung 13 in vielen Altern um einen Stamm, jede in ihrer eigenen senkrechten Ebene; die unteren sind älter.",
    ],
    "figure-17b": [
      "Holz, das dicker wird",
      "Jeder Schritt fügt allem älteren Holz eine Röhre hinzu. Die Basis wird steif, während die Spitze dünn bleibt.",
    ],
    "figure-17c": [
      "Holz, das dicker wird, weicher",
      "Dieselbe Achse mit einem Viertel der Steifigkeit sackt weiter ab, und ein Teil davon bleibt: Nehmen Sie die Lasten ab, um es zu sehen.",
    ],
    "figure-17d": [
      "Achsen mit Dickenwachstum um einen Stamm",
      "Die Achse von Abbildung 17 in vielen Altern um einen Stamm: der Umriss eines jungen Nadelbaums.",
    ],
    "figure-18a": [
      "Ungleiche Gabelungen, hängend",
      "Sie beginnt 60 Grad abwärts. An jeder Gabelung wendet sich der dünnere Trieb weiter ab, und alles hängt.",
    ],
    "figure-18b": [
      "Gleiche Gabelungen, steigend",
      "Sie beginnt 60 Grad aufwärts. Gleich dicke Triebe wenden sich gleich weit ab; die Schwerkraft biegt sie auseinander.",
    ],
    "figure-20a": [
      "Ein Segment und ein schwacher Tropismus",
      "Ein Segment beginnt unter 10 Grad und wendet sich ein wenig dem Vektor zu, der senkrecht nach oben zeigt.",
    ],
    "figure-20b": ["Ein Segment und ein starker Tropismus", "Dasselbe Segment erreicht den Vektor fast."],
    "figure-21a": [
      "Gabelungen und ein schwacher Tropismus",
      "Alle Achsen suchen die Richtung, in der die erste beginnt, 45 Grad aufwärts, aber schwach: Sie spreizen sich.",
    ],
    "figure-21b": [
      "Gabelungen und ein starker Tropismus",
      "Dasselbe mit starkem Tropismus: Bald nach jeder Gabelung laufen die Triebe wieder nebeneinander her.",
    ],
    "figure-21c": [
      "Gabelungen, die die Waagrechte suchen",
      "Ein mittelstarker Tropismus zur Waagrechten breitet die Pflanze wie einen Teller aus.",
    ],
    "weeping-willow": [
      "Trauerweide",
      "Ihre Triebe wachsen weiter, lange nachdem sie sich nicht mehr halten können: Sie neigen sich über und hängen wie Seile.",
    ],
    "silver-birch": [
      "Hängebirke",
      "Schlanke Äste steigen steil auf; ihre dünnen Enden, schwer von Laub, nicken ringsum.",
    ],
    "scots-pine": [
      "Waldkiefer",
      "Quirle kräftiger Äste, jeder mit Nadeln in Büscheln an Enden, die sich aufrichten.",
    ],
    "norway-spruce": [
      "Fichte",
      "Alte Äste sinken unter ihrer Last, ihre Enden richten sich wieder auf: der Umriss einer Fichte.",
    ],
    apple: [
      "Ein Apfelzweig im Frühling",
      "Vor der Frucht steigt er mit fünfundvierzig Grad auf, und sein Holz wird dicker, wo es steht.",
    ],
    "apple-fruit": [
      "Ein Apfelzweig mit Früchten",
      "Derselbe Zweig, unter seinen Früchten gewachsen. Pflücken Sie sie: Er hebt sich wieder, doch weniger, als er sank, denn das Holz erinnert sich.",
    ],
    wheat: [
      "Weizen im Wind",
      "Ein hohler Halm mit reifer Ähre in einem Wind von 8 m/s. Der Widerstand folgt der Biegung: Versuchen Sie 15 m/s, und sehen Sie, wo der Halm bricht.",
    ],
    climber: [
      "Ein kletternder Trieb",
      "Ein Suchtrieb, der keinen Halt fand, wächst über die Länge hinaus, in der er stehen kann, neigt sich über und richtet seine Spitze wieder auf.",
    ],
    snowdrop: [
      "Ein Schneeglöckchen",
      "Der Stängel steht; was sich unter der Blüte biegt, ist sein dünnes Ende.",
    ],
  },
  names: {
    axis: "Achse",
    material: "Holz",
    tropism: "Wuchsrichtung",
    growth: "Dickenwachstum",
    branching: "Verzweigung",
    arrangement: "Anordnung",
    loads: "Lasten",
    solver: "Berechnung",
    none: "Ohne",
    pipes: "Röhren",
    bifurcation: "Gabelung",
    single: "Einzeln",
    stem: "Stamm",
    paper: "Veröffentlichung",
    secondOrder: "Zweite Ordnung",
    newton: "Newton",
    euler: "Euler",
    exact: "Exakt",
    static: "Statisch",
    extrapolated: "Extrapoliert",
    flexibleStem: "Biegsamer Stamm",
  },
  issues: {
    mustBe: "{0}: nötig ist {1}, angegeben ist {2}.",
    number: "eine Zahl von {0} bis {1}{2}",
    integer: "eine ganze Zahl von {0} bis {1}{2}",
    vector: "drei Zahlen, jede von {0} bis {1}{2}",
    choice: "eines von {0}",
    flag: "wahr oder falsch",
    forces: "eine Liste aus {segment, force: [x, y, z]}",
    text: "der Text „{0}“",
    list: "eine Liste mit {0} Einträgen",
    object: "ein Objekt",
    unknownKey: "{0} ist kein Parameter.",
    wrongType: "{0} muss ein Objekt mit benannten Werten sein.",
    unreadable: "{0} lässt sich nicht lesen.",
    "unsupported loads.forces": "{0}: an einem Stamm gibt es keine.",
    "unsupported axis.taper":
      "{0} muss über 0 liegen, wenn sich Achsen gabeln: Aus einem Punkt kann kein Trieb wachsen.",
    "tooLarge branching.generations": "{0}: {2} ergeben zu viele Segmente; höchstens {3} passen hier.",
    "tooLarge axis.segments":
      "{0}: {2} sind zu viele; höchstens {3} passen hier. Weniger, längere Segmente ergeben dieselbe Form.",
    "tooLarge arrangement.count": "{0}: {2} ergeben zu viele Segmente; höchstens {3} passen hier.",
    optional: "eine Zahl von {0} bis {1}{2}, oder nichts",
    "unsupported branching.generations":
      "{0}: {2} machen die Zweige unmessbar dünn; höchstens {3} passen hier.",
    "unsupported solver.method":
      "{0}: Für eine Pflanze, die nicht in einer senkrechten Ebene liegt, ist „Newton“ nötig; die Relaxation der Veröffentlichung ist eben.",
  },
  sources: {
    section: "Abschnitt",
    sections: "Abschnitte",
    equation: "Gleichung",
    equations: "Gleichungen",
    figure: "Abbildung",
    figures: "Abbildungen",
    and: "und",
    to: "bis",
    phyllotaxis: "Blattstellung",
    plastochron: "Plastochron",
    "section 3, and half masses at both ends of a segment":
      "Abschnitt 3, mit halben Massen an beiden Enden eines Segments",
    "past the paper: three dimensions": "über die Veröffentlichung hinaus: drei Dimensionen",
    "section 5.2 in three dimensions": "Abschnitt 5.2 in drei Dimensionen",
    "Hoerner 1965, cross-flow principle": "Hoerner 1965, Querströmungsprinzip",
    "loads along the axis, as equation 9 has them": "Lasten entlang der Achse, wie in Gleichung 9",
    chosen: "gewählt",
  },
};
