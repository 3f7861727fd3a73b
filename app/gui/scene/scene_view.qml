// SPDX-License-Identifier: GPL-3.0-or-later
// The scene graph only: what is drawn and how it is lit. SceneView (C++) sets every property.
import QtQuick
import QtQuick3D
import Torsio.Scene

Rectangle {
    id: root

    property alias organ: organGeometry
    property alias skin: skinData
    property alias ghost: ghostGeometry
    property alias surroundings: surroundingsData
    property alias markers: markerGeometry
    property alias wire: wireGeometry
    property alias lattice: latticeGeometry
    property alias graspBand: graspGeometry
    property alias shaft: shaftGeometry
    property alias upperJaw: upperJawGeometry
    property alias lowerJaw: lowerJawGeometry

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

    property vector3d surroundingsPosition
    property real surroundingsSize: 100   // mm: side of the square

    property color backdropTop: "#eef2f5"
    property color backdropBottom: "#c9d4dc"
    property real tissueRoughness: 0.45
    property real filmAmount: 0.4
    property real filmRoughness: 0.2
    property real scatter: 1
    property real foldDepth: 0
    property real poreDepth: 0
    property vector3d relief
    property bool stressVisible: false
    property color wireColour: "#20323c"
    property color latticeColour: "#12303c"
    property color graspColour: "#0f766e"
    property color shaftColour: "#343b42"

    property bool forceVisible: false
    property vector3d forcePosition
    property quaternion forceRotation
    property real forceLength: 20     // mm
    property real forceThickness: 1   // mm: of the shaft of the arrow
    property color forceColour: "#9a5b00"
    property bool markersVisible: false
    property color markerColour: "#0b6384"
    property bool ghostVisible: false
    property color ghostColour: "#065f7e"

    property bool wireVisible: false
    property bool latticeVisible: false
    property bool graspVisible: true
    property bool fine: false        // antialiasing, shadow, ambient occlusion and the film of moisture

    gradient: Gradient {
        GradientStop { position: 0; color: root.backdropTop }
        GradientStop { position: 1; color: root.backdropBottom }
    }

    View3D {
        anchors.fill: parent
        // Straight into the picture: a picture of its own would be drawn, copied, and asked for a second time
        // after each change. Antialiasing needs one.
        renderMode: root.fine ? View3D.Offscreen : View3D.Inline
        camera: camera

        environment: SceneEnvironment {
            backgroundMode: SceneEnvironment.Transparent
            lightProbe: Texture { source: "qrc:/torsio/scene/studio_light.ktx" }
            probeExposure: root.fine ? 0.44 : 0.46
            tonemapMode: SceneEnvironment.TonemapModeLinear
            antialiasingMode: root.fine ? SceneEnvironment.MSAA : SceneEnvironment.NoAA
            antialiasingQuality: SceneEnvironment.High
            aoStrength: root.fine ? 30 : 0
            aoDistance: 18
            aoSoftness: 20
            aoSampleRate: 3
        }

        PerspectiveCamera {
            id: camera
            position: root.cameraPosition
            rotation: root.cameraRotation
            fieldOfView: root.cameraFieldOfView
            clipNear: root.cameraNear
            clipFar: root.cameraFar

            // The lamp beside the lens goes along: no side of the organ is ever without form.
            DirectionalLight {
                eulerRotation: Qt.vector3d(-14, 34, 0)
                color: "#fbf4ef"
                brightness: 0.38
            }
        }

        // The operating lamp stays where the room has it.
        DirectionalLight {
            eulerRotation: Qt.vector3d(-52, -26, 0)
            color: "#fff4ea"
            brightness: root.fine ? 0.62 : 0.48
            castsShadow: root.fine
            shadowFactor: 38
            shadowMapQuality: Light.ShadowMapQualityHigh
            shadowBias: 4
            shadowFilter: 6
        }
        Texture {
            id: skinTexture
            textureData: SkinTexture { id: skinData }
            generateMipmaps: true
            mipFilter: Texture.Linear
        }

        // The fast level: the painted skin, and a shine.
        PrincipledMaterial {
            id: plainTissue
            baseColorMap: skinTexture
            metalness: 0
            roughness: root.tissueRoughness * (1 - 0.45 * root.filmAmount)
            specularAmount: 0.35
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
        // A map is read by its colours: no light changes them.
        PrincipledMaterial {
            id: stressMap
            lighting: PrincipledMaterial.NoLighting
        }

        // What lies behind the organ, with its shadow painted on: no lamp is asked, at either level.
        Model {
            objectName: "surroundings"
            source: "#Rectangle"    // 100 high, 100 wide
            position: root.surroundingsPosition
            scale: Qt.vector3d(0.01 * root.surroundingsSize, 0.01 * root.surroundingsSize, 1)
            // Drawn first and leaving no depth: it hides nothing, also where the instrument comes from behind.
            depthBias: -100000
            castsShadows: false
            receivesShadows: false
            materials: PrincipledMaterial {
                lighting: PrincipledMaterial.NoLighting
                depthDrawMode: Material.NeverDepthDraw
                baseColorMap: Texture {
                    textureData: SurroundingsTexture { id: surroundingsData }
                    generateMipmaps: true
                    mipFilter: Texture.Linear
                }
            }
        }

        Model {
            objectName: "organ"
            geometry: OrganGeometry { id: organGeometry }
            receivesShadows: root.fine
            castsShadows: root.fine
            materials: root.stressVisible ? stressMap : root.fine ? livingTissue : plainTissue
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

        // The pose to reach, as a film over the scene.
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

        // The force of the tissue on the instrument: a shaft with a head, standing on the contact.
        Node {
            id: forceArrow
            visible: root.forceVisible
            position: root.forcePosition
            rotation: root.forceRotation
            readonly property real head: Math.min(0.4 * root.forceLength, 5.5 * root.forceThickness)
            readonly property real stem: root.forceLength - head

            PrincipledMaterial {
                id: forceMaterial
                lighting: PrincipledMaterial.NoLighting
                baseColor: root.forceColour
            }
            Model {
                source: "#Cylinder"     // 100 high, 100 wide
                castsShadows: false
                y: 0.5 * forceArrow.stem
                scale: Qt.vector3d(0.01 * root.forceThickness, 0.01 * forceArrow.stem, 0.01 * root.forceThickness)
                materials: forceMaterial
            }
            Model {
                source: "#Cone"         // 100 high, 100 wide, standing on its base
                castsShadows: false
                y: forceArrow.stem
                scale: Qt.vector3d(0.03 * root.forceThickness, 0.01 * forceArrow.head, 0.03 * root.forceThickness)
                materials: forceMaterial
            }
            Model {
                source: "#Sphere"       // the contact itself
                castsShadows: false
                scale: Qt.vector3d(0.018, 0.018, 0.018).times(root.forceThickness)
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

            PrincipledMaterial {
                id: plainSteel
                baseColor: "#cfd3d8"
                metalness: 0.95
                roughness: 0.28
            }
            CustomMaterial {
                id: brushedSteel
                shadingMode: CustomMaterial.Shaded
                vertexShader: "qrc:/torsio/shaders/steel.vert"
                fragmentShader: "qrc:/torsio/shaders/steel.frag"
            }
            PrincipledMaterial {
                id: insulation
                baseColor: root.shaftColour
                metalness: 0
                roughness: 0.42
            }

            Model {
                geometry: InstrumentGeometry { id: shaftGeometry }
                castsShadows: root.fine
                materials: insulation
            }
            Model {
                geometry: InstrumentGeometry { id: upperJawGeometry }
                pivot: root.jawPivot
                position: root.jawPivot
                eulerRotation.x: root.jawAngle
                castsShadows: root.fine
                materials: root.fine ? brushedSteel : plainSteel
            }
            Model {
                geometry: InstrumentGeometry { id: lowerJawGeometry }
                pivot: root.jawPivot
                position: root.jawPivot
                eulerRotation.x: -root.jawAngle
                castsShadows: root.fine
                materials: root.fine ? brushedSteel : plainSteel
            }
        }
    }
}
