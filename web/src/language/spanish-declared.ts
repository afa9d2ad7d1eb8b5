/** The page in Spanish: what parameters, presets and errors say. */
import type { Dictionary } from "./dictionary.ts";

export const declared: Omit<Dictionary, "texts"> = {
  parameters: {
    "axis.segments": [
      "Segmentos",
      "A cuántos segmentos llega un eje; el principal gana uno en cada paso de crecimiento.",
    ],
    "axis.segmentLength": ["Longitud de segmento", "Longitud media de un segmento."],
    "axis.lengthProfile": [
      "Perfil de longitud",
      "Longitud de los segmentos centrales entre la de los extremos: 1 los hace todos iguales, más alarga los centrales.",
    ],
    "axis.radius": [
      "Radio",
      "Radio de un segmento recién formado (un tubo); con ahusamiento, el radio en la base.",
    ],
    "axis.taper": [
      "Ahusamiento",
      "Radio en el ápice entre radio en la base, lineal a lo largo del eje terminado: 1 es uniforme, 0 un cono. Sin efecto cuando la madera engruesa por tubos, que hacen su propio ahusamiento.",
    ],
    "axis.elevation": [
      "Elevación",
      "Dirección en la que el eje sale de su base, sobre la horizontal; negativa apunta hacia abajo.",
    ],
    "axis.azimuth": [
      "Azimut",
      "Rumbo del plano vertical del eje: su giro en torno a la vertical, en sentido antihorario visto desde arriba.",
    ],
    "axis.restCurvature": [
      "Curvatura innata",
      "Flexión de la madera nueva antes de toda carga: la curvatura que conservaría en caída libre; positiva dobla hacia la cara superior.",
    ],
    "axis.restCurvatureRoll": [
      "Giro de la curvatura innata",
      "Dirección en torno al eje hacia la que se dobla la madera nueva: 0 es su cara superior, 90 el lado derecho de quien mira a lo largo del eje.",
    ],
    "axis.restTwist": [
      "Torsión innata",
      "Torsión de la madera nueva, en radianes por metro, como en la fibra en espiral: con una curvatura innata el eje crece en hélice, de radio c/(c^2 + t^2) y paso 2 pi t/(c^2 + t^2).",
    ],
    "material.youngsModulus": [
      "Módulo de Young",
      "Rigidez de la madera a la flexión: la madera verde tiene de 1 a 15 GPa, los brotes tiernos una centésima parte.",
    ],
    "material.density": ["Densidad", "Masa de la madera por volumen; la madera fresca se acerca al agua."],
    "material.shearModulusRatio": [
      "Razón del módulo de corte",
      "Módulo de corte entre módulo de Young, que resiste la torsión: GJ/EI de una sección redonda es el doble. La madera tiene de 0,06 a 0,12, el caucho 0,33.",
    ],
    "material.modulusOfRupture": [
      "Módulo de rotura",
      "Tensión de fibra con la que la madera se rompe: la madera verde aguanta de 30 a 80 MPa, los brotes tiernos una décima parte.",
    ],
    "tropism.elevation": [
      "Dirección preferida",
      "La dirección en la que el eje busca crecer, sobre la horizontal: 90 es recto hacia arriba, 0 horizontal, -90 recto hacia abajo.",
    ],
    "tropism.azimuth": [
      "Azimut de la dirección preferida",
      "Rumbo de lo que se busca, el mismo para todos los ejes, como luz de un lado; sin él cada eje busca en su propio plano vertical.",
    ],
    "tropism.strength": [
      "Fuerza del tropismo",
      "Con qué rapidez la madera nueva se vuelve hacia la dirección preferida, por metro de crecimiento: 0 es nada, 1e6 o más es del todo. La madera nueva que apunta justo en sentido contrario no tiene lado hacia el que volverse y conserva su dirección.",
    ],
    "growth.thickening": [
      "Engrosamiento",
      "Si la madera vieja engruesa: con tubos, cada segmento viejo gana en cada paso de crecimiento un tubo de igual área, puesto sin tensión.",
    ],
    "branching.pattern": [
      "Ramificación",
      "Si un eje adulto acaba en una horquilla: con bifurcación, en dos brotes de grosor desigual, que son ejes nuevos.",
    ],
    "branching.generations": ["Generaciones", "Cuántas veces se bifurca cada camino."],
    "branching.lengthRatio": [
      "Razón de longitudes",
      "Segmentos de un eje hijo entre los de su padre, redondeados, al menos uno.",
    ],
    "branching.exponent": [
      "Exponente de Murray",
      "Exponente de los grosores en una horquilla: 2 conserva el área (da Vinci) y ambos brotes siguen rectos, 2,49 es el del artículo, 3 es la ley de Murray para los vasos; más separa más los brotes.",
    ],
    "branching.girthRatio": [
      "Razón de grosores",
      "Grosor del brote más fino entre el del más grueso; el más fino se desvía más.",
    ],
    "branching.roll": [
      "Giro de las horquillas",
      "Giro del plano de cada horquilla en torno a su padre, desde el plano de la horquilla anterior: a 0 todas están en un plano y el brote más grueso gira en sentido antihorario, a 90 las horquillas se cruzan; más allá los brotes cambian de lado, de modo que 180 es la imagen especular de 0.",
    ],
    "arrangement.pattern": [
      "Disposición",
      "Una planta; o copias de ella en torno a un tallo recto y rígido, cada una en su propio plano vertical, las de abajo más viejas; o ejes en un tallo que crece él mismo, y se dobla y se tuerce bajo ellos.",
    ],
    "arrangement.count": [
      "Ejes en el tallo",
      "Cuántos ejes lleva el tallo cuando todos han empezado a crecer.",
    ],
    "arrangement.spacing": ["Distancia en el tallo", "Longitud de tallo entre un eje y el siguiente."],
    "arrangement.trunk": [
      "Tronco desnudo",
      "Longitud de tallo desnudo abajo; por encima empieza la primera distancia.",
    ],
    "arrangement.divergence": [
      "Ángulo de divergencia",
      "Giro en torno al tallo de un eje al siguiente; 137,5 es el ángulo áureo de la filotaxis en espiral, 180 hace dos filas.",
    ],
    "arrangement.interval": [
      "Intervalo",
      "Pasos de crecimiento desde el comienzo de un eje hasta el del siguiente, encima de él; un eje cuya hora no ha llegado aún no existe.",
    ],
    "arrangement.stemRadius": [
      "Radio del tallo",
      "Radio de un segmento recién formado de un tallo flexible (un tubo); un tallo rígido es tan grueso como exigen los ejes de encima.",
    ],
    "arrangement.stemElevation": [
      "Elevación del tallo",
      "Dirección en la que un tallo flexible sale del suelo, sobre la horizontal; sus ejes se inclinan con él.",
    ],
    "loads.gravity": [
      "Gravedad",
      "Aceleración de la gravedad: 9,81 en la Tierra, 1,62 en la Luna, 0 en caída libre.",
    ],
    "loads.tipMass": [
      "Masa en el ápice",
      "Un fruto o una flor en cada ápice, que se lleva desde el primer paso de crecimiento.",
    ],
    "loads.foliage": [
      "Follaje",
      "Masa de las hojas por metro de madera joven, soportada en cada paso de crecimiento.",
    ],
    "loads.foliageAge": [
      "Edad del follaje",
      "Durante cuántos pasos de crecimiento un segmento lleva hojas: eso cuenta como madera joven.",
    ],
    "loads.foliageArea": [
      "Área del follaje",
      "Área de las hojas, de una cara, por masa: lo que encuentran el viento y la nieve. Las hojas anchas y frescas tienen de 3 a 6, las acículas de 1 a 2.",
    ],
    "loads.snow": [
      "Nieve o lluvia",
      "Masa que yace sobre la planta adulta, por área de su madera vista desde arriba y de sus hojas: 0,2 con lluvia, de 5 a 40 con nieve.",
    ],
    "loads.wind": [
      "Viento",
      "Velocidad de un viento constante sobre la planta adulta. Empuja la madera de través, según el cuadrado de la velocidad que le llega en ángulo recto, y las hojas en su propia dirección.",
    ],
    "loads.windAzimuth": [
      "Dirección del viento",
      "Hacia dónde sopla el viento, girado en torno a la vertical: 0 es hacia la derecha, 180 hacia la izquierda.",
    ],
    "loads.dragCoefficient": [
      "Resistencia de la madera",
      "Coeficiente de resistencia de la madera, referido a su diámetro; una varilla redonda tiene cerca de 1.",
    ],
    "loads.foliageDrag": [
      "Resistencia del follaje",
      "Coeficiente de resistencia de las hojas, referido a su área en aire quieto; se pliegan con el viento, así que es muy inferior al de una placa.",
    ],
    "loads.tipForce": [
      "Fuerza en el ápice",
      "Una fuerza x, y, z sobre el ápice del eje principal, que actúa en cada paso de crecimiento sobre el ápice de esa edad. En torno a un tallo, x apunta hacia fuera.",
    ],
    "loads.forces": [
      "Fuerzas en segmentos",
      "Fuerzas que tiran del extremo distal de segmentos tras el crecimiento, como hace un puntero: una lista de {segment, force: [x, y, z]}. No está en los enlaces.",
    ],
    "loads.picked": [
      "Recoger la fruta",
      "Tras el crecimiento, quitar las masas de los ápices y mostrar cuánto vuelve a alzarse la planta.",
    ],
    "loads.removed": [
      "Quitar las cargas",
      "Tras el crecimiento, quitar todas las cargas y mostrar lo que queda doblado: la forma que la madera recuerda.",
    ],
    "solver.discretization": [
      "Discretización",
      "Cómo se corta la varilla continua: la manera del artículo es de primer orden, la otra de segundo, de modo que bastan pocos segmentos.",
    ],
    "solver.method": [
      "Método",
      "Cómo se halla el equilibrio: el método de Newton con la hessiana exacta, o la relajación de Euler amortiguada del artículo, mucho más lenta.",
    ],
    "solver.tolerance": [
      "Tolerancia",
      "Mayor par que puede quedar en una articulación, respecto al mayor par de la planta.",
    ],
    "solver.stepping": [
      "Pasos",
      "«Exacto» lleva cada paso de crecimiento al equilibrio; «estático» resuelve de una vez la planta terminada, con sus cargas subiendo desde cero, sin memoria de cómo creció; «extrapolado» prevé esa memoria a partir de cortes más gruesos de un solo eje cortado por igual, y dice cuánto puede equivocarse (las demás plantas crecen de forma exacta).",
    ],
    "solver.space": [
      "Siempre en el espacio",
      "Calcula también con varillas en el espacio las plantas que están en un plano vertical: la misma forma, más despacio. Todas las demás se calculan así de todos modos.",
    ],
  },
  presets: {
    "figure-2a": [
      "Recto hacia arriba",
      "Ortogravitropismo negativo: empiece donde empiece, el órgano gira hasta crecer recto hacia arriba.",
    ],
    "figure-2b": [
      "Inclinado hacia arriba",
      "Plagiogravitropismo negativo: el órgano se queda a un ángulo sobre la horizontal, como muchas ramas.",
    ],
    "figure-2c": [
      "Horizontal",
      "Diagravitropismo: el órgano crece a nivel, como los estolones y los rizomas.",
    ],
    "figure-2d": [
      "Inclinado hacia abajo",
      "Plagiogravitropismo positivo: el órgano se queda a un ángulo bajo la horizontal, como las raíces laterales.",
    ],
    "figure-2e": [
      "Recto hacia abajo",
      "Ortogravitropismo positivo: el órgano gira hasta crecer recto hacia abajo, como una raíz principal.",
    ],
    "figure-8a": [
      "Un eje bajo la gravedad, joven",
      "Un eje corto apenas siente su peso: sale de la base a 50 grados y sigue casi recto.",
    ],
    "figure-8b": [
      "Un eje bajo la gravedad, creciendo",
      "El doble de largo es ocho veces el número de gravedad (el cubo de la longitud): el ápice empieza a inclinarse.",
    ],
    "figure-8c": [
      "Un eje bajo la gravedad, arqueado",
      "Ahora se arquea todo el eje, y su ápice apunta bajo la horizontal.",
    ],
    "figure-8d": [
      "Un eje bajo la gravedad, adulto",
      "El ápice cuelga: la misma madera, solo que más larga. La flexión crece con el cubo de la longitud.",
    ],
    "figure-10": [
      "La misma varilla, cortada de forma desigual",
      "Segmentos cortos en los extremos y largos en el centro dan (casi) la forma de la figura 8: el corte no importa.",
    ],
    "figure-13a": [
      "Un tropismo contra la gravedad, joven",
      "La madera nueva empieza siempre a 45 grados; un eje corto puede sostenerla ahí.",
    ],
    "figure-13b": [
      "Un tropismo contra la gravedad, creciendo",
      "La madera vieja cede bajo lo que lleva mientras el ápice aún busca 45 grados: empieza una S.",
    ],
    "figure-13c": [
      "Un tropismo contra la gravedad, adulto",
      "La forma en S de muchas ramas: la parte vieja cede, la joven se endereza. Hay una inflexión.",
    ],
    "figure-13d": [
      "Ejes que buscan en torno a un tallo",
      "El eje de la figura 13 a muchas edades en torno a un tallo, cada uno en su propio plano vertical; los de abajo son más viejos.",
    ],
    "figure-17b": [
      "Madera que engruesa",
      "Cada paso añade un tubo a toda la madera vieja. La base se hace rígida mientras el ápice sigue fino.",
    ],
    "figure-17c": [
      "Madera que engruesa, más blanda",
      "El mismo eje con la cuarta parte de la rigidez cede más, y una parte de eso queda: quite las cargas para verlo.",
    ],
    "figure-17d": [
      "Ejes que engruesan en torno a un tallo",
      "El eje de la figura 17 a muchas edades en torno a un tallo: el contorno de una conífera joven.",
    ],
    "figure-18a": [
      "Horquillas desiguales, colgantes",
      "Empieza 60 grados hacia abajo. En cada horquilla el brote más fino se desvía más, y todo cuelga.",
    ],
    "figure-18b": [
      "Horquillas iguales, ascendentes",
      "Empieza 60 grados hacia arriba. Brotes de igual grosor se desvían por igual; la gravedad los separa.",
    ],
    "figure-20a": [
      "Un segmento y un tropismo débil",
      "Un segmento empieza a 10 grados y se vuelve un poco hacia el vector, que apunta recto hacia arriba.",
    ],
    "figure-20b": ["Un segmento y un tropismo fuerte", "El mismo segmento casi alcanza el vector."],
    "figure-21a": [
      "Horquillas y un tropismo débil",
      "Todos los ejes buscan la dirección en que empieza el primero, 45 grados hacia arriba, pero débilmente: se separan.",
    ],
    "figure-21b": [
      "Horquillas y un tropismo fuerte",
      "Lo mismo con un tropismo fuerte: poco después de cada horquilla los brotes vuelven a ir uno junto a otro.",
    ],
    "figure-21c": [
      "Horquillas que buscan la horizontal",
      "Un tropismo de fuerza media hacia la horizontal extiende la planta como un plato.",
    ],
    "weeping-willow": [
      "Sauce llorón",
      "Sus ramas siguen creciendo mucho después de poder sostenerse: se arquean y cuelgan como cuerdas.",
    ],
    "silver-birch": [
      "Abedul péndulo",
      "Ramas esbeltas suben empinadas; sus extremos finos, cargados de hojas, cabecean alrededor.",
    ],
    "scots-pine": [
      "Pino silvestre",
      "Verticilos de ramas robustas, cada una con sus acículas en penachos en extremos que se alzan.",
    ],
    "norway-spruce": [
      "Pícea",
      "Las ramas viejas ceden bajo lo que llevan, sus extremos vuelven a alzarse: la silueta de una pícea.",
    ],
    apple: [
      "Una rama de manzano en primavera",
      "Antes del fruto sube a cuarenta y cinco grados, y su madera engrosa donde está.",
    ],
    "apple-fruit": [
      "Una rama de manzano con fruta",
      "La misma rama, crecida bajo su fruta. Recójala: vuelve a alzarse, pero menos de lo que bajó, pues la madera recuerda.",
    ],
    wheat: [
      "Trigo al viento",
      "Una caña hueca con espiga madura en un viento de 8 m/s. La resistencia sigue la flexión: pruebe 15 m/s y vea dónde se rompe la caña.",
    ],
    climber: [
      "Un brote trepador",
      "Un brote buscador que no halló apoyo crece más allá de la longitud con que puede estar de pie, se arquea y vuelve a alzar su ápice.",
    ],
    snowdrop: [
      "Una campanilla de invierno",
      "El tallo se mantiene en pie; lo que se dobla bajo la flor es su extremo fino.",
    ],
  },
  names: {
    axis: "Eje",
    material: "Madera",
    tropism: "Dirección de crecimiento",
    growth: "Engrosamiento",
    branching: "Ramificación",
    arrangement: "Disposición",
    loads: "Cargas",
    solver: "Cálculo",
    none: "Sin",
    pipes: "Tubos",
    bifurcation: "Bifurcación",
    single: "Una sola",
    stem: "Tallo",
    paper: "Artículo",
    secondOrder: "Segundo orden",
    newton: "Newton",
    euler: "Euler",
    exact: "Exacto",
    static: "Estático",
    extrapolated: "Extrapolado",
    flexibleStem: "Tallo flexible",
  },
  issues: {
    mustBe: "{0}: hace falta {1}; se dio {2}.",
    number: "un número de {0} a {1}{2}",
    integer: "un número entero de {0} a {1}{2}",
    vector: "tres números, cada uno de {0} a {1}{2}",
    choice: "uno de estos valores: {0}",
    flag: "verdadero o falso",
    forces: "una lista de {segment, force: [x, y, z]}",
    text: "el texto «{0}»",
    list: "una lista de {0} elementos",
    object: "un objeto",
    unknownKey: "{0} no es un parámetro.",
    wrongType: "{0} debe ser un objeto con valores con nombre.",
    unreadable: "{0} no se puede leer.",
    "unsupported loads.forces": "{0}: en torno a un tallo no las hay.",
    "unsupported axis.taper":
      "{0} debe ser mayor que 0 cuando los ejes se bifurcan: un brote no puede crecer de un punto.",
    "tooLarge branching.generations": "{0}: {2} dan demasiados segmentos; aquí caben {3} como mucho.",
    "tooLarge axis.segments":
      "{0}: {2} son demasiados; aquí caben {3} como mucho. Menos segmentos y más largos dan la misma forma.",
    "tooLarge arrangement.count": "{0}: {2} dan demasiados segmentos; aquí caben {3} como mucho.",
    optional: "un número de {0} a {1}{2}, o nada",
    "unsupported branching.generations":
      "{0}: {2} hacen las ramas inmensurablemente finas; aquí caben {3} como mucho.",
    "unsupported solver.method":
      "{0}: para una planta que no está en un plano vertical hace falta «Newton»; la relajación del artículo es plana.",
  },
  sources: {
    section: "sección",
    sections: "secciones",
    equation: "ecuación",
    equations: "ecuaciones",
    figure: "figura",
    figures: "figuras",
    and: "y",
    to: "a",
    phyllotaxis: "filotaxis",
    plastochron: "plastocrono",
    "section 3, and half masses at both ends of a segment":
      "sección 3, con medias masas en ambos extremos de un segmento",
    "past the paper: three dimensions": "más allá del artículo: tres dimensiones",
    "section 5.2 in three dimensions": "sección 5.2 en tres dimensiones",
    "Hoerner 1965, cross-flow principle": "Hoerner 1965, principio del flujo transversal",
    "loads along the axis, as equation 9 has them": "cargas a lo largo del eje, como en la ecuación 9",
    chosen: "elegido",
  },
};
