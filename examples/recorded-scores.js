/** Recorded scores in the format of a face tracker, for tracker.html. Not part of the library. */

/** Pairs of a time in seconds and the scores at this time. */
const RECORDING = [
  [0, {}],
  [
    1,
    {
      browInnerUp: 0.9,
      browOuterUpLeft: 0.95,
      browOuterUpRight: 0.9,
      eyeWideLeft: 0.5,
      eyeWideRight: 0.5,
      jawOpen: 0.25,
    },
  ],
  [
    2.2,
    {
      browInnerUp: 0.8,
      browOuterUpLeft: 0.9,
      browOuterUpRight: 0.8,
      eyeWideLeft: 0.4,
      eyeWideRight: 0.4,
      jawOpen: 0.15,
    },
  ],
  [3, { mouthSmileLeft: 0.3, mouthSmileRight: 0.35 }],
  [
    4,
    {
      mouthSmileLeft: 0.9,
      mouthSmileRight: 0.95,
      cheekSquintLeft: 0.7,
      cheekSquintRight: 0.7,
      eyeSquintLeft: 0.5,
      eyeSquintRight: 0.5,
    },
  ],
  [
    5,
    {
      mouthSmileLeft: 0.7,
      mouthSmileRight: 0.8,
      cheekSquintLeft: 0.5,
      cheekSquintRight: 0.6,
      eyeBlinkLeft: 0.2,
      eyeBlinkRight: 0.2,
    },
  ],
  [
    6,
    {
      browDownLeft: 0.9,
      browDownRight: 0.85,
      noseSneerLeft: 0.4,
      noseSneerRight: 0.3,
      mouthPressLeft: 0.4,
      mouthPressRight: 0.4,
    },
  ],
  [7, { browDownLeft: 0.7, browDownRight: 0.8, eyeSquintLeft: 0.3, eyeSquintRight: 0.3 }],
  [8, {}],
]
const NAMES = [...new Set(RECORDING.flatMap(([, scores]) => Object.keys(scores)))]

/**
 * Returns the scores at a time from 0 to 8 seconds, in the format of `faceBlendshapes[0].categories` of MediaPipe's
 * face landmarker.
 */
export function recordedScores(seconds) {
  const next = Math.max(
    1,
    RECORDING.findIndex(([time]) => time >= seconds),
  )
  const [[from, before], [to, after]] = [RECORDING[next - 1], RECORDING[next]]
  const fraction = Math.min(1, (seconds - from) / (to - from))
  const scores = NAMES.map((categoryName) => {
    const [a, b] = [before[categoryName] ?? 0, after[categoryName] ?? 0]
    return { categoryName, score: a + (b - a) * fraction }
  })
  return [{ categoryName: '_neutral', score: 0.1 }, ...scores]
}
