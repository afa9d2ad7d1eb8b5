/** The page in French: what parameters, presets and errors say. */
import type { Dictionary } from "./dictionary.ts";

export const declared: Omit<Dictionary, "texts"> = {
  parameters: {
    "axis.segments": [
      "Segments",
      "À combien de segments un axe parvient ; l’axe principal en gagne un à chaque étape de croissance.",
    ],
    "axis.segmentLength": ["Longueur des segments", "Longueur moyenne d’un segment."],
    "axis.lengthProfile": [
      "Profil de longueur",
      "Longueur des segments du milieu sur celle des segments extrêmes : 1 les rend tous égaux, davantage allonge ceux du milieu.",
    ],
    "axis.radius": [
      "Rayon",
      "Rayon d’un segment nouvellement formé (un tube) ; avec une décroissance, le rayon à la base.",
    ],
    "axis.taper": [
      "Décroissance",
      "Rayon à l’apex sur rayon à la base, linéaire le long de l’axe achevé : 1 est uniforme, 0 un cône. Sans effet quand le bois s’épaissit par tubes, qui font leur propre décroissance.",
    ],
    "axis.elevation": [
      "Élévation",
      "Direction dans laquelle l’axe quitte sa base, au-dessus de l’horizontale ; une valeur négative pointe vers le bas.",
    ],
    "axis.azimuth": [
      "Azimut",
      "Direction horizontale du plan vertical de l’axe : sa rotation autour de la verticale, dans le sens inverse des aiguilles d’une montre vue d’en haut.",
    ],
    "axis.restCurvature": [
      "Courbure innée",
      "Flexion du bois nouveau avant toute charge : la courbure qu’il garderait en chute libre ; une valeur positive courbe vers la face supérieure.",
    ],
    "axis.restCurvatureRoll": [
      "Roulis de la courbure innée",
      "Direction autour de l’axe vers laquelle le bois nouveau est courbé : 0 est sa face supérieure, 90 le côté droit pour qui regarde le long de l’axe.",
    ],
    "axis.restTwist": [
      "Torsion innée",
      "Torsion du bois nouveau, en radians par mètre, comme dans le fil spiralé : avec une courbure innée, l’axe pousse en hélice de rayon c/(c^2 + t^2) et de pas 2 pi t/(c^2 + t^2).",
    ],
    "material.youngsModulus": [
      "Module de Young",
      "Rigidité du bois en flexion : le bois vert a de 1 à 15 GPa, les pousses tendres un centième de cela.",
    ],
    "material.density": ["Masse volumique", "Masse du bois par volume ; le bois frais est proche de l’eau."],
    "material.shearModulusRatio": [
      "Rapport du module de cisaillement",
      "Module de cisaillement sur module de Young, qui résiste à la torsion : GJ/EI d’une section ronde en est le double. Le bois a environ 0,06 à 0,12, le caoutchouc 0,33.",
    ],
    "material.modulusOfRupture": [
      "Contrainte de rupture",
      "Contrainte de fibre à laquelle le bois casse : le bois vert tient de 30 à 80 MPa, les pousses tendres un dixième de cela.",
    ],
    "tropism.elevation": [
      "Direction préférée",
      "La direction dans laquelle l’axe cherche à pousser, au-dessus de l’horizontale : 90 est droit vers le haut, 0 horizontal, -90 droit vers le bas.",
    ],
    "tropism.azimuth": [
      "Azimut de la direction préférée",
      "Direction horizontale de ce qui est cherché, la même pour tous les axes, comme une lumière latérale ; sans elle, chaque axe cherche dans son propre plan vertical.",
    ],
    "tropism.strength": [
      "Force du tropisme",
      "À quelle vitesse le bois nouveau se tourne vers la direction préférée, par mètre de croissance : 0 est nul, 1e6 et plus est total. Un bois nouveau qui pointe exactement à l’opposé n’a pas de côté vers lequel se tourner et garde sa direction.",
    ],
    "growth.thickening": [
      "Épaississement",
      "Si le bois ancien s’épaissit : avec des tubes, chaque segment ancien gagne à chaque étape de croissance un tube de même aire, posé sans contrainte.",
    ],
    "branching.pattern": [
      "Ramification",
      "Si un axe adulte finit en fourche : avec bifurcation, en deux rameaux de grosseur inégale, qui sont de nouveaux axes.",
    ],
    "branching.generations": ["Générations", "Combien de fois chaque chemin bifurque."],
    "branching.lengthRatio": [
      "Rapport de longueur",
      "Segments d’un axe fils sur ceux de son parent, arrondis, au moins un.",
    ],
    "branching.exponent": [
      "Exposant de Murray",
      "Exposant des grosseurs à une fourche : 2 conserve l’aire (Léonard de Vinci) et les deux rameaux vont tout droit, 2,49 est celui de l’article, 3 la loi de Murray pour les vaisseaux ; davantage écarte plus les rameaux.",
    ],
    "branching.girthRatio": [
      "Rapport de grosseur",
      "Grosseur du rameau le plus mince sur celle du plus gros ; le plus mince se détourne davantage.",
    ],
    "branching.roll": [
      "Roulis des fourches",
      "Rotation du plan de chaque fourche autour de son parent, à partir du plan de la fourche précédente : à 0 toutes sont dans un même plan et le rameau le plus gros tourne dans le sens inverse des aiguilles d’une montre, à 90 les fourches se croisent ; au-delà, les rameaux changent de côté, si bien que 180 est l’image miroir de 0.",
    ],
    "arrangement.pattern": [
      "Disposition",
      "Une plante ; ou des copies autour d’une tige droite et rigide, chacune dans son propre plan vertical, les plus basses étant les plus âgées ; ou des axes sur une tige qui pousse elle-même, et fléchit et se tord sous eux.",
    ],
    "arrangement.count": [
      "Axes sur la tige",
      "Combien d’axes porte la tige quand tous ont commencé à pousser.",
    ],
    "arrangement.spacing": ["Espacement sur la tige", "Longueur de tige entre un axe et le suivant."],
    "arrangement.trunk": [
      "Tronc nu",
      "Longueur de tige nue en bas ; au-dessus commence le premier espacement.",
    ],
    "arrangement.divergence": [
      "Angle de divergence",
      "Rotation autour de la tige d’un axe au suivant ; 137,5 est l’angle d’or de la phyllotaxie spiralée, 180 fait deux rangs.",
    ],
    "arrangement.interval": [
      "Intervalle",
      "Étapes de croissance du début d’un axe au début du suivant, au-dessus de lui ; un axe dont l’heure n’est pas venue n’existe pas encore.",
    ],
    "arrangement.stemRadius": [
      "Rayon de la tige",
      "Rayon d’un segment nouvellement formé d’une tige souple (un tube) ; une tige rigide est aussi grosse que les axes au-dessus l’exigent.",
    ],
    "arrangement.stemElevation": [
      "Élévation de la tige",
      "Direction dans laquelle une tige souple quitte le sol, au-dessus de l’horizontale ; ses axes s’inclinent avec elle.",
    ],
    "loads.gravity": [
      "Pesanteur",
      "Accélération de la pesanteur : 9,81 sur Terre, 1,62 sur la Lune, 0 en chute libre.",
    ],
    "loads.tipMass": [
      "Masse à l’apex",
      "Un fruit ou une fleur à chaque apex, porté dès la première étape de croissance.",
    ],
    "loads.foliage": [
      "Feuillage",
      "Masse des feuilles par mètre de bois jeune, portée à chaque étape de croissance.",
    ],
    "loads.foliageAge": [
      "Âge du feuillage",
      "Pendant combien d’étapes de croissance un segment porte des feuilles : c’est ce qui compte comme bois jeune.",
    ],
    "loads.foliageArea": [
      "Surface du feuillage",
      "Surface des feuilles, d’un côté, par masse : ce que rencontrent le vent et la neige. Les feuilles larges et fraîches ont de 3 à 6, les aiguilles de 1 à 2.",
    ],
    "loads.snow": [
      "Neige ou pluie",
      "Masse posée sur la plante adulte, par surface de son bois vu d’en haut et de ses feuilles : 0,2 pour la pluie, 5 à 40 pour la neige.",
    ],
    "loads.wind": [
      "Vent",
      "Vitesse d’un vent constant sur la plante adulte. Il pousse le bois en travers, selon le carré de la vitesse qui l’atteint à angle droit, et les feuilles dans sa propre direction.",
    ],
    "loads.windAzimuth": [
      "Direction du vent",
      "Où souffle le vent, tourné autour de la verticale : 0 est vers la droite, 180 vers la gauche.",
    ],
    "loads.dragCoefficient": [
      "Traînée du bois",
      "Coefficient de traînée du bois, rapporté à son diamètre ; une tige ronde a environ 1.",
    ],
    "loads.foliageDrag": [
      "Traînée du feuillage",
      "Coefficient de traînée des feuilles, rapporté à leur surface en air calme ; elles se replient au vent, il est donc bien inférieur à celui d’une plaque.",
    ],
    "loads.tipForce": [
      "Force à l’apex",
      "Une force x, y, z sur l’apex de l’axe principal, qui agit à chaque étape de croissance sur l’apex de cet âge. Autour d’une tige, x s’en éloigne.",
    ],
    "loads.forces": [
      "Forces sur les segments",
      "Forces qui tirent au bout distal de segments après la croissance, comme le fait un pointeur : une liste de {segment, force: [x, y, z]}. Absentes des liens.",
    ],
    "loads.picked": [
      "Cueillir les fruits",
      "Après la croissance, ôter les masses aux extrémités et montrer jusqu’où la plante se relève.",
    ],
    "loads.removed": [
      "Ôter les charges",
      "Après la croissance, ôter toutes les charges et montrer ce qui reste courbé : la forme dont le bois se souvient.",
    ],
    "solver.discretization": [
      "Discrétisation",
      "Comment la tige continue est découpée : la façon de l’article est du premier ordre, l’autre du second, si bien que peu de segments suffisent.",
    ],
    "solver.method": [
      "Méthode",
      "Comment l’équilibre est trouvé : la méthode de Newton avec la hessienne exacte, ou la relaxation d’Euler amortie de l’article, bien plus lente.",
    ],
    "solver.tolerance": [
      "Tolérance",
      "Plus grand couple qui peut rester à une articulation, relativement au plus grand couple de la plante.",
    ],
    "solver.stepping": [
      "Pas à pas",
      "« Exact » amène chaque étape de croissance à l’équilibre ; « statique » résout la plante achevée d’un coup, ses charges montant de zéro, sans mémoire de sa croissance ; « extrapolé » prévoit cette mémoire à partir de découpages plus grossiers d’un axe unique découpé régulièrement, et dit de combien il peut se tromper (les autres plantes poussent exactement).",
    ],
    "solver.space": [
      "Toujours dans l’espace",
      "Calcule aussi avec des tiges dans l’espace les plantes qui tiennent dans un plan vertical : la même forme, plus lentement. Toutes les autres sont calculées ainsi de toute façon.",
    ],
  },
  presets: {
    "figure-2a": [
      "Droit vers le haut",
      "Orthogravitropisme négatif : où qu’il commence, l’organe tourne jusqu’à pousser droit vers le haut.",
    ],
    "figure-2b": [
      "En biais vers le haut",
      "Plagiogravitropisme négatif : l’organe se fixe à un angle au-dessus de l’horizontale, comme bien des branches.",
    ],
    "figure-2c": [
      "À l’horizontale",
      "Diagravitropisme : l’organe pousse à plat, comme les stolons et les rhizomes.",
    ],
    "figure-2d": [
      "En biais vers le bas",
      "Plagiogravitropisme positif : l’organe se fixe à un angle sous l’horizontale, comme les racines latérales.",
    ],
    "figure-2e": [
      "Droit vers le bas",
      "Orthogravitropisme positif : l’organe tourne jusqu’à pousser droit vers le bas, comme une racine principale.",
    ],
    "figure-8a": [
      "Un axe sous la pesanteur, jeune",
      "Un axe court sent à peine son poids : il quitte la base à 50 degrés et reste presque droit.",
    ],
    "figure-8b": [
      "Un axe sous la pesanteur, en croissance",
      "Deux fois plus long, c’est huit fois le nombre de gravité (le cube de la longueur) : l’apex commence à se pencher.",
    ],
    "figure-8c": [
      "Un axe sous la pesanteur, arqué",
      "Tout l’axe s’arque à présent, et son apex pointe sous l’horizontale.",
    ],
    "figure-8d": [
      "Un axe sous la pesanteur, adulte",
      "L’apex pend : le même bois, seulement plus long. La flexion croît avec le cube de la longueur.",
    ],
    "figure-10": [
      "La même tige, découpée inégalement",
      "Des segments courts aux bouts et longs au milieu font (presque) la forme de la figure 8 : le découpage n’importe pas.",
    ],
    "figure-13a": [
      "Un tropisme contre la pesanteur, jeune",
      "Le bois nouveau commence toujours à 45 degrés ; un axe court peut l’y tenir.",
    ],
    "figure-13b": [
      "Un tropisme contre la pesanteur, en croissance",
      "Le bois ancien s’affaisse sous ce qu’il porte tandis que l’apex cherche encore 45 degrés : un S commence.",
    ],
    "figure-13c": [
      "Un tropisme contre la pesanteur, adulte",
      "La forme en S de bien des branches : la partie âgée s’affaisse, la jeune se redresse. Il y a une inflexion.",
    ],
    "figure-13d": [
      "Des axes chercheurs autour d’une tige",
      "L’axe de la figure 13 à bien des âges autour d’une tige, chacun dans son propre plan vertical ; les plus bas sont les plus âgés.",
    ],
    "figure-17b": [
      "Un bois qui s’épaissit",
      "Chaque étape ajoute un tube à tout le bois ancien. La base devient rigide tandis que l’apex reste mince.",
    ],
    "figure-17c": [
      "Un bois qui s’épaissit, plus souple",
      "Le même axe, quatre fois moins rigide, s’affaisse davantage, et une part en demeure : ôtez les charges pour le voir.",
    ],
    "figure-17d": [
      "Des axes qui s’épaississent autour d’une tige",
      "L’axe de la figure 17 à bien des âges autour d’une tige : la silhouette d’un jeune conifère.",
    ],
    "figure-18a": [
      "Fourches inégales, pendantes",
      "Il part à 60 degrés vers le bas. À chaque fourche le rameau le plus mince se détourne davantage, et tout pend.",
    ],
    "figure-18b": [
      "Fourches égales, montantes",
      "Il part à 60 degrés vers le haut. Des rameaux de même grosseur se détournent également ; la pesanteur les écarte.",
    ],
    "figure-20a": [
      "Un segment et un faible tropisme",
      "Un segment part à 10 degrés et se tourne un peu vers le vecteur, qui pointe droit vers le haut.",
    ],
    "figure-20b": ["Un segment et un fort tropisme", "Le même segment atteint presque le vecteur."],
    "figure-21a": [
      "Fourches et un faible tropisme",
      "Tous les axes cherchent la direction où part le premier, 45 degrés vers le haut, mais faiblement : ils s’écartent.",
    ],
    "figure-21b": [
      "Fourches et un fort tropisme",
      "La même chose avec un fort tropisme : peu après chaque fourche, les rameaux courent de nouveau côte à côte.",
    ],
    "figure-21c": [
      "Fourches qui cherchent l’horizontale",
      "Un tropisme de force moyenne vers l’horizontale étale la plante comme une assiette.",
    ],
    "weeping-willow": [
      "Saule pleureur",
      "Ses rameaux poussent encore bien après ne plus pouvoir se tenir : ils se courbent et pendent comme des cordes.",
    ],
    "silver-birch": [
      "Bouleau verruqueux",
      "Des branches élancées montent raide ; leurs bouts minces, lourds de feuilles, s’inclinent tout autour.",
    ],
    "scots-pine": [
      "Pin sylvestre",
      "Des verticilles de fortes branches, chacune avec ses aiguilles en touffes aux bouts qui se redressent.",
    ],
    "norway-spruce": [
      "Épicéa",
      "Les vieilles branches ploient sous ce qu’elles portent, leurs bouts se redressent : la silhouette d’un épicéa.",
    ],
    apple: [
      "Une branche de pommier au printemps",
      "Avant les fruits elle monte à quarante-cinq degrés, et son bois épaissit là où il est.",
    ],
    "apple-fruit": [
      "Une branche de pommier chargée",
      "La même branche, poussée sous ses fruits. Cueillez-les : elle se relève, mais moins qu’elle n’avait ployé, car le bois se souvient.",
    ],
    wheat: [
      "Le blé dans le vent",
      "Une paille creuse avec un épi mûr dans un vent de 8 m/s. La traînée suit la flexion : essayez 15 m/s, et voyez où la paille casse.",
    ],
    climber: [
      "Une pousse grimpante",
      "Une pousse exploratrice sans appui grandit au-delà de la longueur où elle tient debout, se courbe, et redresse son extrémité.",
    ],
    snowdrop: ["Un perce-neige", "La tige tient droite ; ce qui plie sous la fleur, c’est son bout mince."],
  },
  names: {
    axis: "Axe",
    material: "Bois",
    tropism: "Direction de croissance",
    growth: "Épaississement",
    branching: "Ramification",
    arrangement: "Disposition",
    loads: "Charges",
    solver: "Calcul",
    none: "Sans",
    pipes: "Tubes",
    bifurcation: "Bifurcation",
    single: "Seule",
    stem: "Tige",
    paper: "Article",
    secondOrder: "Second ordre",
    newton: "Newton",
    euler: "Euler",
    exact: "Exact",
    static: "Statique",
    extrapolated: "Extrapolé",
    flexibleStem: "Tige souple",
  },
  issues: {
    mustBe: "{0} : il faut {1} ; reçu : {2}.",
    number: "un nombre de {0} à {1}{2}",
    integer: "un nombre entier de {0} à {1}{2}",
    vector: "trois nombres, chacun de {0} à {1}{2}",
    choice: "l’une de ces valeurs : {0}",
    flag: "vrai ou faux",
    forces: "une liste de {segment, force: [x, y, z]}",
    text: "le texte « {0} »",
    list: "une liste de {0} éléments",
    object: "un objet",
    unknownKey: "{0} n’est pas un paramètre.",
    wrongType: "{0} doit être un objet à valeurs nommées.",
    unreadable: "{0} ne peut pas être lu.",
    "unsupported loads.forces": "{0} : autour d’une tige il n’y en a pas.",
    "unsupported axis.taper":
      "{0} doit être supérieur à 0 quand les axes bifurquent : un rameau ne peut pousser d’un point.",
    "tooLarge branching.generations": "{0} : {2} font trop de segments ; {3} au plus sont possibles ici.",
    "tooLarge axis.segments":
      "{0} : {2} sont trop ; {3} au plus sont possibles ici. Des segments moins nombreux et plus longs donnent la même forme.",
    "tooLarge arrangement.count": "{0} : {2} font trop de segments ; {3} au plus sont possibles ici.",
    optional: "un nombre de {0} à {1}{2}, ou rien",
    "unsupported branching.generations":
      "{0} : {2} rendent les rameaux infiniment minces ; {3} au plus sont possibles ici.",
    "unsupported solver.method":
      "{0} : il faut « Newton » pour une plante qui ne tient pas dans un plan vertical ; la relaxation de l’article est plane.",
  },
  sources: {
    section: "section",
    sections: "sections",
    equation: "équation",
    equations: "équations",
    figure: "figure",
    figures: "figures",
    and: "et",
    to: "à",
    phyllotaxis: "phyllotaxie",
    plastochron: "plastochrone",
    "section 3, and half masses at both ends of a segment":
      "section 3, avec des demi-masses aux deux bouts d’un segment",
    "past the paper: three dimensions": "au-delà de l’article : trois dimensions",
    "section 5.2 in three dimensions": "section 5.2 en trois dimensions",
    "Hoerner 1965, cross-flow principle": "Hoerner 1965, principe de l’écoulement transversal",
    "loads along the axis, as equation 9 has them": "charges le long de l’axe, comme dans l’équation 9",
    chosen: "choisi",
  },
};
