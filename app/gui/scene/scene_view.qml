// SPDX-License-Identifier: GPL-3.0-or-later
// The scene graph: models, materials and lights. SceneView (C++) sets every property.
import QtQuick
import QtQuick3D
import Torsio.Scene

Item {
    id: root

    property alias organ: organGeometry
    property alias organVertices: organVerticesData
    property alias organNeighbours: organNeighboursData
    property alias organRows: organRowsData
    property alias skin: skinData
    property alias ghost: ghostGeometry
    property alias surroundings: surroundingsData
    property alias shadow: shadowData
    property alias mesentery: mesenteryGeometry
    property alias mesenteryPaint: mesenteryData
    property alias continuations: continuationGeometry
    property alias markers: markerGeometry
    property alias wire: wireGeometry
    property alias lattice: latticeGeometry
    property alias graspBand: graspGeometry
    property alias shaft: shaftGeometry
    property alias upperJaw: upperJawGeometry
    property alias lowerJaw: lowerJawGeometry
    property alias hand: handGeometry
    property alias sleeve: sleeveGeometry
    property alias drape: drapeGeometry
    property alias portBody: portBodyGeometry
    property alias portSeal: portSealGeometry
    property alias arrowStem: arrowStemGeometry
    property alias arrowHead: arrowHeadGeometry
    property alias arrowFoot: arrowFootGeometry
    property alias organEdge: organEdgeGeometry
    property alias solidEdge: solidEdgeGeometry
    // Each with colour and surface kind: 0 plastic, 0.25 cloth, 1 steel, -1 unlit.
    readonly property var solids: [shaftModel, upperJawModel, lowerJawModel, handModel, sleeveModel,
                                   drapeModel, portBodyModel, portSealModel, arrowStemModel, arrowHeadModel, arrowFootModel]

    property vector3d cameraPosition
    property quaternion cameraRotation
    property real cameraFieldOfView: 32
    property real cameraNear: 10
    property real cameraFar: 5000
    property vector3d toolPosition
    property quaternion toolRotation
    property real jawAngle: 12       // each jaw, degrees
    property vector3d jawPivot
    property bool toolVisible: true
    property bool handVisible: false
    property bool portVisible: false
    property real portAlong: 100     // mm from the tip, where the shaft passes the port

    property vector3d surroundingsPosition
    property bool surroundingsVisible: true
    property bool drapeVisible: false     // over the upper arm
    property bool mesenteryVisible: false
    property bool continuationsVisible: false
    property real surroundingsSize: 100   // side of the square, mm
    property real shadowShare: 1          // ratio of the sides of square and shadow
    property color gloveColour: "#8fb3cf"
    property color gownColour: "#7fa9b5"
    property color clothColour: "#aecfcc"
    property color portColour: "#b9c6cd"
    property color neighbourColour: "#c4bab7"
    property color steelColour: "#9aa0a6"

    property real tissueRoughness: 0.45
    property real filmAmount: 0.4
    property real filmRoughness: 0.2
    property real scatter: 1
    property real foldDepth: 0
    property real poreDepth: 0
    property vector3d relief
    property real paintedRelief: 0     // range of the painted skin's fourth channel, mm
    property bool stressVisible: false
    property bool deformedByShader: false
    property vector3d organBlood: Qt.vector3d(1, 1, 1)   // factor on the colour of what is twisted, sRGB
    // Under the instrument, m: place and reach; depth along the normal, and radius of the tool.
    property vector4d dentPlace0
    property vector4d dentDepth0
    property vector4d dentPlace1
    property vector4d dentDepth1
    property color wireColour: "#20323c"
    property color latticeColour: "#12303c"
    property color graspColour: "#0f766e"
    property color shaftColour: "#343b42"

    property bool forceVisible: false
    property vector3d forcePosition
    property quaternion forceRotation
    property real forceLength: 20     // mm
    property real forceThickness: 1   // of the arrow's shaft, mm
    property color forceColour: "#9a5b00"
    property bool markersVisible: false
    property color markerColour: "#0b6384"
    property bool ghostVisible: false
    property color ghostColour: "#065f7e"

    property bool wireVisible: false
    property bool latticeVisible: false
    property bool graspVisible: true
    property bool fine: false        // antialiasing, shadow, ambient occlusion and moisture
    property bool best: false        // the fine level with maximum settings

    // Positions of the lamps for the fast level's shader.
    readonly property vector3d lampDirection: Qt.vector3d(-0.27, 0.788, 0.553)
    readonly property vector3d shaftDirection: root.toolRotation.times(Qt.vector3d(0, 0, 1))
    readonly property vector3d lensDirection: root.cameraRotation.times(Qt.vector3d(-0.54, 0.24, 0.80))

    // Plastic, rubber and steel, lit by the same two lamps and a room of a few colours.
    component Solid: CustomMaterial {
        property color colour
        property vector3d own: Qt.vector3d(colour.r, colour.g, colour.b)
        property real surface: 0
        property real scratches: 0       // tilt of the steel
        property vector3d lampDirection
        property vector3d lensDirection
        property vector3d shaftDirection
        shadingMode: CustomMaterial.Unshaded
        vertexShader: "qrc:/torsio/shaders/solid.vert"
        fragmentShader: "qrc:/torsio/shaders/solid.frag"
    }

    View3D {
        id: view
        anchors.fill: parent
        // Directly into the window, which saves a copy. Antialiasing needs an offscreen buffer; the fast level
        // has soft edges instead.
        renderMode: root.fine ? View3D.Offscreen : View3D.Inline
        camera: camera

        environment: SceneEnvironment {
            backgroundMode: SceneEnvironment.Transparent
            lightProbe: Texture { source: "qrc:/torsio/scene/studio_light.ktx" }
            probeExposure: root.fine ? 0.44 : 0.46
            tonemapMode: SceneEnvironment.TonemapModeLinear
            antialiasingMode: root.fine ? SceneEnvironment.MSAA : SceneEnvironment.NoAA
            antialiasingQuality: root.best ? SceneEnvironment.VeryHigh : SceneEnvironment.High
            aoStrength: root.fine && !root.deformedByShader ? 30 : 0
            aoDistance: 18
            aoSoftness: 20
            aoSampleRate: root.best ? 4 : 3
        }

        PerspectiveCamera {
            id: camera
            position: root.cameraPosition
            rotation: root.cameraRotation
            fieldOfView: root.cameraFieldOfView
            clipNear: root.cameraNear
            clipFar: root.cameraFar

            // The lamp beside the lens moves with the camera, so that every side of the organ is shaded.
            DirectionalLight {
                eulerRotation: Qt.vector3d(-14, 34, 0)
                color: "#fbf4ef"
                brightness: 0.38
            }
        }

        // The operating lamp is fixed in the room.
        DirectionalLight {
            eulerRotation: Qt.vector3d(-52, -26, 0)
            color: "#fff4ea"
            brightness: root.fine ? 0.62 : 0.48
            castsShadow: root.fine
            shadowFactor: 38
            shadowMapQuality: root.best ? Light.ShadowMapQualityVeryHigh : Light.ShadowMapQualityHigh
            shadowBias: 4
            shadowFilter: root.best ? 10 : 6
        }
        // Outside of the materials and before them: Qt Quick 3D notifies a material of its texture's destruction
        // even if the material has been destroyed.
        Texture {
            id: groundTexture
            textureData: SurroundingsTexture { id: surroundingsData }
            tilingModeHorizontal: Texture.ClampToEdge
            tilingModeVertical: Texture.ClampToEdge
        }
        Texture {
            id: shadowTexture
            textureData: ShadowTexture { id: shadowData }
            tilingModeHorizontal: Texture.ClampToEdge
            tilingModeVertical: Texture.ClampToEdge
        }
        Texture {
            id: mesenteryTexture
            textureData: SurroundingsTexture { id: mesenteryData }
            generateMipmaps: true
            mipFilter: Texture.Linear
            tilingModeHorizontal: Texture.ClampToEdge
            tilingModeVertical: Texture.ClampToEdge
        }
        Texture {
            id: skinTexture
            textureData: SkinTexture { id: skinData }
            generateMipmaps: true
            mipFilter: Texture.Linear
        }

        component NumberMap: Texture {
            minFilter: Texture.Nearest
            magFilter: Texture.Nearest
            mipFilter: Texture.None
            tilingModeHorizontal: Texture.ClampToEdge
            tilingModeVertical: Texture.ClampToEdge
        }
        NumberMap {
            id: organVerticesMap
            textureData: NumberTexture { id: organVerticesData }
        }
        NumberMap {
            id: organNeighboursMap
            textureData: NumberTexture { id: organNeighboursData }
        }
        NumberMap {
            id: organRowsMap
            textureData: NumberTexture { id: organRowsData }
        }

        // The fast level: the painted skin, lit by the same lamps without the light probe.
        CustomMaterial {
            id: plainTissue
            shadingMode: CustomMaterial.Unshaded
            vertexShader: "qrc:/torsio/shaders/quick_tissue.vert"
            fragmentShader: "qrc:/torsio/shaders/quick_tissue.frag"
            property TextureInput skinMap: TextureInput { texture: skinTexture }
            property vector3d lampDirection: root.lampDirection
            property vector3d lensDirection: root.lensDirection
            property vector3d lampColour: Qt.vector3d(0.86, 0.82, 0.78)
            property vector3d scatterWay: Qt.vector3d(0.55, 0.20, 0.14).times(root.scatter)
            property vector3d scatterRim: Qt.vector3d(0.35, 0.06, 0.04).times(root.scatter)
            property real wetness: root.filmAmount
            property real relief: root.paintedRelief
        }
        CustomMaterial {
            id: tissueEdge
            shadingMode: CustomMaterial.Unshaded
            sourceBlend: CustomMaterial.One
            destinationBlend: CustomMaterial.OneMinusSrcAlpha
            cullMode: Material.NoCulling
            vertexShader: plainTissue.vertexShader
            fragmentShader: plainTissue.fragmentShader
            property TextureInput skinMap: TextureInput { texture: skinTexture }
            property vector3d lampDirection: root.lampDirection
            property vector3d lensDirection: root.lensDirection
            property vector3d lampColour: plainTissue.lampColour
            property vector3d scatterWay: plainTissue.scatterWay
            property vector3d scatterRim: plainTissue.scatterRim
            property real wetness: root.filmAmount
            property real relief: 0
        }
        CustomMaterial {
            id: livingTissue
            shadingMode: CustomMaterial.Shaded
            vertexShader: "qrc:/torsio/shaders/tissue.vert"
            fragmentShader: "qrc:/torsio/shaders/tissue.frag"
            property TextureInput skinMap: TextureInput { texture: skinTexture }
            property real tissueRoughness: root.tissueRoughness
            property real filmRoughness: root.filmRoughness
            property real wetness: root.filmAmount
            property real scatter: root.scatter
            property real foldDepth: root.foldDepth
            property real poreDepth: root.poreDepth
            property real bumpBroad: root.relief.x
            property real bumpMiddle: root.relief.y
            property real bumpSmall: root.relief.z
        }
        // The same on a graphics card, which deforms the organ.
        CustomMaterial {
            id: movedTissue
            shadingMode: CustomMaterial.Shaded
            vertexShader: "qrc:/torsio/shaders/moved_tissue.vert"
            fragmentShader: livingTissue.fragmentShader
            property TextureInput skinMap: TextureInput { texture: skinTexture }
            property TextureInput organVertices: TextureInput { texture: organVerticesMap }
            property TextureInput organNeighbours: TextureInput { texture: organNeighboursMap }
            property TextureInput organRows: TextureInput { texture: organRowsMap }
            property vector3d organBlood: root.organBlood
            property vector4d dentPlace0: root.dentPlace0
            property vector4d dentDepth0: root.dentDepth0
            property vector4d dentPlace1: root.dentPlace1
            property vector4d dentDepth1: root.dentDepth1
            property real tissueRoughness: root.tissueRoughness
            property real filmRoughness: root.filmRoughness
            property real wetness: root.filmAmount
            property real scatter: root.scatter
            property real foldDepth: root.foldDepth
            property real poreDepth: root.poreDepth
            property real bumpBroad: root.relief.x
            property real bumpMiddle: root.relief.y
            property real bumpSmall: root.relief.z
        }
        // A map is read by its colours: light may darken them, but not change their hue.
        CustomMaterial {
            id: stressMap
            shadingMode: CustomMaterial.Unshaded
            vertexShader: "qrc:/torsio/shaders/stress_map.vert"
            fragmentShader: "qrc:/torsio/shaders/stress_map.frag"
            property vector3d lampDirection: root.lampDirection
        }
        CustomMaterial {
            id: stressEdge
            shadingMode: CustomMaterial.Unshaded
            sourceBlend: CustomMaterial.One
            destinationBlend: CustomMaterial.OneMinusSrcAlpha
            cullMode: Material.NoCulling
            vertexShader: stressMap.vertexShader
            fragmentShader: stressMap.fragmentShader
            property vector3d lampDirection: root.lampDirection
        }

        // The square behind the organ, with its shadow: unlit at both levels.
        Model {
            objectName: "surroundings"
            visible: root.surroundingsVisible
            source: "#Rectangle"    // 100 high, 100 wide
            position: root.surroundingsPosition
            id: surroundingsModel
            scale: Qt.vector3d(0.01 * beyond * root.surroundingsSize, 0.01 * beyond * root.surroundingsSize, 1)
            readonly property real beyond: 4    // a view may be much wider than high
            // Drawn last and farthest away: it costs nothing where it is covered, and hides nothing, even if
            // the instrument comes from behind.
            depthBias: 100000
            castsShadows: false
            receivesShadows: false
            materials: CustomMaterial {
                shadingMode: CustomMaterial.Unshaded
                depthDrawMode: Material.NeverDepthDraw
                vertexShader: "qrc:/torsio/shaders/surroundings.vert"
                fragmentShader: "qrc:/torsio/shaders/surroundings.frag"
                property real beyond: surroundingsModel.beyond
                property real shadowShare: root.shadowShare
                property real shadowDepth: 0.46
                property TextureInput ground: TextureInput { texture: groundTexture }
                property TextureInput shadow: TextureInput { texture: shadowTexture }
            }
        }

        // The mesentery of a loop of bowel: in front of the square and behind everything else, visual only.
        Model {
            objectName: "mesentery"
            visible: root.mesenteryVisible && root.surroundingsVisible
            geometry: MesenteryGeometry { id: mesenteryGeometry }
            depthBias: 90000
            castsShadows: false
            receivesShadows: false
            materials: CustomMaterial {
                shadingMode: CustomMaterial.Unshaded
                sourceBlend: CustomMaterial.One
                destinationBlend: CustomMaterial.OneMinusSrcAlpha
                cullMode: Material.NoCulling
                depthDrawMode: Material.NeverDepthDraw
                vertexShader: "qrc:/torsio/shaders/mesentery.vert"
                fragmentShader: "qrc:/torsio/shaders/mesentery.frag"
                property TextureInput fan: TextureInput { texture: mesenteryTexture }
            }
        }

        Solid {
            id: plainCloth
            colour: root.clothColour
            surface: 0.25
            lampDirection: root.lampDirection
            lensDirection: root.lensDirection
            shaftDirection: root.shaftDirection
        }
        PrincipledMaterial {
            id: cloth
            baseColor: root.clothColour
            roughness: 0.95
            specularAmount: 0.1
        }
        // The drape over the upper arm.
        Model {
            id: drapeModel
            objectName: "drape"
            readonly property color colour: root.clothColour
            readonly property real surface: 0.25
            visible: root.drapeVisible && root.surroundingsVisible
            geometry: InstrumentGeometry { id: drapeGeometry }
            castsShadows: root.fine
            materials: root.fine ? cloth : plainCloth
        }

        // From the organ's open ends to what is painted behind it, visual only.
        Model {
            objectName: "continuations"
            visible: root.continuationsVisible && root.surroundingsVisible
            geometry: ContinuationGeometry { id: continuationGeometry }
            castsShadows: false
            receivesShadows: false
            materials: Solid {
                colour: root.neighbourColour
                surface: 0
                lampDirection: root.lampDirection
                lensDirection: root.lensDirection
                shaftDirection: root.shaftDirection
            }
        }

        Model {
            objectName: "organ"
            geometry: OrganGeometry { id: organGeometry }
            receivesShadows: root.fine
            castsShadows: root.fine
            materials: root.stressVisible ? stressMap : !root.fine ? plainTissue : root.deformedByShader ? movedTissue : livingTissue
        }
        // Soft edges of organ and solids, one pixel wide: smooth without antialiasing.
        Model {
            objectName: "organEdge"
            visible: !root.fine
            geometry: OutlineGeometry { id: organEdgeGeometry }
            castsShadows: false
            receivesShadows: false
            materials: root.stressVisible ? stressEdge : tissueEdge
        }
        Model {
            objectName: "solidEdge"
            visible: !root.fine
            geometry: OutlineGeometry { id: solidEdgeGeometry }
            castsShadows: false
            receivesShadows: false
            materials: Solid {
                colour: "white"
                sourceBlend: CustomMaterial.One
                destinationBlend: CustomMaterial.OneMinusSrcAlpha
                cullMode: Material.NoCulling
                lampDirection: root.lampDirection
                lensDirection: root.lensDirection
                shaftDirection: root.shaftDirection
            }
        }

        Model {
            visible: root.wireVisible
            geometry: WireGeometry { id: wireGeometry }
            castsShadows: false
            materials: PrincipledMaterial {
                lighting: PrincipledMaterial.NoLighting
                baseColor: root.wireColour
                opacity: 0.55
            }
        }

        Model {
            visible: root.latticeVisible
            geometry: RibbonGeometry { id: latticeGeometry }
            castsShadows: false
            materials: PrincipledMaterial {
                lighting: PrincipledMaterial.NoLighting
                baseColor: root.latticeColour
                cullMode: Material.NoCulling
            }
        }

        Model {
            visible: root.graspVisible
            geometry: RibbonGeometry { id: graspGeometry }
            castsShadows: false
            materials: PrincipledMaterial {
                lighting: PrincipledMaterial.NoLighting
                baseColor: root.graspColour
                cullMode: Material.NoCulling
            }
        }

        // The target pose, translucent.
        Model {
            visible: root.ghostVisible
            geometry: OrganGeometry { id: ghostGeometry }
            castsShadows: false
            receivesShadows: false
            materials: PrincipledMaterial {
                lighting: PrincipledMaterial.NoLighting
                baseColor: root.ghostColour
                opacity: 0.16
            }
        }

        // The force of the tissue on the instrument: an arrow at the contact.
        Node {
            id: forceArrow
            visible: root.forceVisible
            position: root.forcePosition
            rotation: root.forceRotation
            readonly property real head: Math.min(0.4 * root.forceLength, 5.5 * root.forceThickness)
            readonly property real stem: root.forceLength - head

            Solid {
                id: forceMaterial
                colour: root.forceColour
                surface: -1
                lampDirection: root.lampDirection
                lensDirection: root.lensDirection
                shaftDirection: root.shaftDirection
            }
            // Bodies of revolution about z, of unit length and unit radius.
            Model {
                id: arrowStemModel
                readonly property color colour: root.forceColour
                readonly property real surface: -1
                geometry: InstrumentGeometry { id: arrowStemGeometry }
                castsShadows: false
                scale: Qt.vector3d(0.5 * root.forceThickness, 0.5 * root.forceThickness, forceArrow.stem)
                materials: forceMaterial
            }
            Model {
                id: arrowHeadModel
                readonly property color colour: root.forceColour
                readonly property real surface: -1
                geometry: InstrumentGeometry { id: arrowHeadGeometry }
                castsShadows: false
                z: forceArrow.stem
                scale: Qt.vector3d(1.5 * root.forceThickness, 1.5 * root.forceThickness, forceArrow.head)
                materials: forceMaterial
            }
            Model {
                id: arrowFootModel      // the contact itself
                readonly property color colour: root.forceColour
                readonly property real surface: -1
                geometry: InstrumentGeometry { id: arrowFootGeometry }
                castsShadows: false
                scale: Qt.vector3d(0.9, 0.9, 0.9).times(root.forceThickness)
                materials: forceMaterial
            }
        }

        Model {
            visible: root.markersVisible
            geometry: MarkerGeometry { id: markerGeometry }
            castsShadows: false
            materials: PrincipledMaterial {
                lighting: PrincipledMaterial.NoLighting
                baseColor: root.markerColour
                cullMode: Material.NoCulling
            }
        }

        Node {
            id: tool
            position: root.toolPosition
            rotation: root.toolRotation
            visible: root.toolVisible

            Solid {
                id: brushedSteel
                colour: root.steelColour
                surface: 1
                scratches: root.fine ? 0.10 : 0
                lampDirection: root.lampDirection
                lensDirection: root.lensDirection
                shaftDirection: root.shaftDirection
            }
            PrincipledMaterial {
                id: insulation
                baseColor: root.shaftColour
                metalness: 0
                roughness: 0.42
            }
            Solid {
                id: plainInsulation
                colour: root.shaftColour
                lampDirection: root.lampDirection
                lensDirection: root.lensDirection
                shaftDirection: root.shaftDirection
            }

            Model {
                id: shaftModel
                readonly property color colour: root.shaftColour
                readonly property real surface: 0
                geometry: InstrumentGeometry { id: shaftGeometry }
                castsShadows: root.fine
                materials: root.fine ? insulation : plainInsulation
            }
            // The surgeon's hand at the end of the shaft, if visible.
            PrincipledMaterial {
                id: glove
                baseColor: root.gloveColour
                metalness: 0
                roughness: 0.38
                specularAmount: 0.55
            }
            Solid {
                id: plainGlove
                colour: root.gloveColour
                lampDirection: root.lampDirection
                lensDirection: root.lensDirection
                shaftDirection: root.shaftDirection
            }
            Model {
                id: handModel
                readonly property color colour: root.gloveColour
                readonly property real surface: 0
                visible: root.handVisible
                geometry: InstrumentGeometry { id: handGeometry }
                castsShadows: root.fine
                materials: root.fine ? glove : plainGlove
            }
            // The sleeve of the gown, from the cuff out of the picture.
            PrincipledMaterial {
                id: gown
                baseColor: root.gownColour
                roughness: 0.95
                specularAmount: 0.1
            }
            Solid {
                id: plainGown
                colour: root.gownColour
                surface: 0.25
                lampDirection: root.lampDirection
                lensDirection: root.lensDirection
                shaftDirection: root.shaftDirection
            }
            Model {
                id: sleeveModel
                readonly property color colour: root.gownColour
                readonly property real surface: 0.25
                visible: root.handVisible
                geometry: InstrumentGeometry { id: sleeveGeometry }
                castsShadows: root.fine
                materials: root.fine ? gown : plainGown
            }

            // The port in the abdominal wall: sleeve, funnel, and the seal around the shaft.
            Node {
                visible: root.portVisible
                z: root.portAlong
                PrincipledMaterial {
                    id: portShell
                    baseColor: root.portColour
                    metalness: 0
                    roughness: 0.25
                }
                Solid {
                    id: plainPortShell
                    colour: root.portColour
                    lampDirection: root.lampDirection
                    lensDirection: root.lensDirection
                    shaftDirection: root.shaftDirection
                }
                Model {
                    id: portBodyModel
                    readonly property color colour: root.portColour
                    readonly property real surface: 0
                    geometry: InstrumentGeometry { id: portBodyGeometry }
                    castsShadows: root.fine
                    materials: root.fine ? portShell : plainPortShell
                }
                Model {
                    id: portSealModel
                    readonly property color colour: root.shaftColour
                    readonly property real surface: 0
                    geometry: InstrumentGeometry { id: portSealGeometry }
                    castsShadows: root.fine
                    materials: root.fine ? insulation : plainInsulation
                }
            }

            Model {
                id: upperJawModel
                readonly property color colour: root.steelColour
                readonly property real surface: 1
                geometry: InstrumentGeometry { id: upperJawGeometry }
                pivot: root.jawPivot
                position: root.jawPivot
                eulerRotation.x: root.jawAngle
                castsShadows: root.fine
                materials: brushedSteel
            }
            Model {
                id: lowerJawModel
                readonly property color colour: root.steelColour
                readonly property real surface: 1
                geometry: InstrumentGeometry { id: lowerJawGeometry }
                pivot: root.jawPivot
                position: root.jawPivot
                eulerRotation.x: -root.jawAngle
                castsShadows: root.fine
                materials: brushedSteel
            }
        }
    }
}
