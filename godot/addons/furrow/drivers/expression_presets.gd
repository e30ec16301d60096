@tool
class_name FurrowExpressionPresets
extends RefCounted
## Expressions for faces without expressions of their own: weights of blendshapes by name, and activations by area.

const EXPRESSIONS := {
	"neutral": {"name": "neutral", "targets": {}, "activations": {}},
	"surprised": {"name": "surprised", "targets": {"browInnerUp": 1, "browOuterUpLeft": 1, "browOuterUpRight": 1, "eyeWideLeft": 0.8, "eyeWideRight": 0.8, "jawOpen": 0.25}, "activations": {"foreheadLeft": 1, "foreheadRight": 1}},
	"angry": {"name": "angry", "targets": {"browDownLeft": 1, "browDownRight": 1, "eyeSquintLeft": 0.4, "eyeSquintRight": 0.4, "noseSneerLeft": 0.35, "noseSneerRight": 0.35, "mouthPressLeft": 0.6, "mouthPressRight": 0.6}, "activations": {"glabella": 1, "nose": 0.35, "nasolabialLeft": 0.25, "nasolabialRight": 0.25, "underEyeLeft": 0.2, "underEyeRight": 0.2}},
	"happy": {"name": "happy", "targets": {"mouthSmileLeft": 0.8, "mouthSmileRight": 0.8, "mouthUpperUpLeft": 0.6, "mouthUpperUpRight": 0.6, "mouthLowerDownLeft": 0.2, "mouthLowerDownRight": 0.2, "cheekSquintLeft": 0.8, "cheekSquintRight": 0.8, "eyeSquintLeft": 0.4, "eyeSquintRight": 0.4, "jawOpen": 0.12}, "activations": {"crowsFeetLeft": 1, "crowsFeetRight": 1, "nasolabialLeft": 0.9, "nasolabialRight": 0.9, "underEyeLeft": 0.9, "underEyeRight": 0.9}},
	"disgusted": {"name": "disgusted", "targets": {"noseSneerLeft": 1, "noseSneerRight": 1, "mouthUpperUpLeft": 0.6, "mouthUpperUpRight": 0.6, "browDownLeft": 0.6, "browDownRight": 0.6, "eyeSquintLeft": 0.5, "eyeSquintRight": 0.5}, "activations": {"nose": 1, "glabella": 0.5, "nasolabialLeft": 0.8, "nasolabialRight": 0.8, "crowsFeetLeft": 0.3, "crowsFeetRight": 0.3, "underEyeLeft": 0.5, "underEyeRight": 0.5}},
	"sad": {"name": "sad", "targets": {"browInnerUp": 0.9, "mouthFrownLeft": 0.9, "mouthFrownRight": 0.9, "mouthShrugLower": 0.4, "eyeLookDownLeft": 0.3, "eyeLookDownRight": 0.3}, "activations": {"foreheadLeft": 0.5, "foreheadRight": 0.5, "glabella": 0.6, "nasolabialLeft": 0.4, "nasolabialRight": 0.4}},
	"leftBrow": {"name": "leftBrow", "targets": {"browOuterUpLeft": 1, "browInnerUp": 0.25}, "activations": {"foreheadLeft": 1}},
	"rightBrow": {"name": "rightBrow", "targets": {"browOuterUpRight": 1, "browInnerUp": 0.25}, "activations": {"foreheadRight": 1}},
	"leftWink": {"name": "leftWink", "targets": {"eyeBlinkLeft": 0.9, "cheekSquintLeft": 0.7, "mouthSmileLeft": 0.35}, "activations": {"crowsFeetLeft": 1, "underEyeLeft": 0.5}},
	"rightWink": {"name": "rightWink", "targets": {"eyeBlinkRight": 0.9, "cheekSquintRight": 0.7, "mouthSmileRight": 0.35}, "activations": {"crowsFeetRight": 1, "underEyeRight": 0.5}},
}
