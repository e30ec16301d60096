/** Blendshapes that the face on the first page of the site keeps, in addition to the blendshapes that its drivers read. */

const both = (name) => [`${name}Left`, `${name}Right`]

export const TARGETS = [
  'browInnerUp',
  ...both('browOuterUp'),
  ...both('browDown'),
  ...both('eyeWide'),
  ...both('eyeSquint'),
  ...both('eyeBlink'),
  ...both('eyeLookUp'),
  ...both('eyeLookDown'),
  ...both('eyeLookIn'),
  ...both('eyeLookOut'),
  ...both('cheekSquint'),
  ...both('noseSneer'),
  ...both('mouthSmile'),
  ...both('mouthUpperUp'),
  ...both('mouthLowerDown'),
  ...both('mouthPress'),
  'jawOpen',
]
