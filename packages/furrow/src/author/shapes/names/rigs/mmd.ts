import type { RigNames } from '../rig-names.ts'

/** Common names of MikuMikuDance morphs. A wink without a side in its name closes the left eye. */
export const MMD: RigNames = {
  source: 'https://www.deviantart.com/xoriu/art/MMD-Facial-Expressions-Chart-341504917',
  same: {
    まばたき: 'eyeBlink',
    ウィンク2: 'eyeBlinkLeft',
    ウィンク2右: 'eyeBlinkRight',
    びっくり: 'eyeWide',
    怒り: 'browDown',
    口角上げ: 'mouthSmile',
    口角下げ: 'mouthFrown',
    口横広げ: 'mouthStretch',
    ぺろっ: 'tongueOut',
    べー: 'tongueOut',
    ぷくー: 'cheekPuff',
  },
  like: {
    上: 'browInnerUp browOuterUp',
    眉上: 'browInnerUp browOuterUp',
    にこり: 'browOuterUp browInnerUp',
    困る: 'browInnerUp',
    下: 'browDown',
    眉下: 'browDown',
    真面目: 'browDown',
    笑い: 'eyeBlink eyeSquint cheekSquint',
    ウィンク: 'eyeBlinkLeft eyeSquintLeft cheekSquintLeft',
    ウィンク右: 'eyeBlinkRight eyeSquintRight cheekSquintRight',
    なごみ: 'eyeBlink',
    じと目: 'eyeSquint',
    キリッ: 'eyeSquint',
    にやり: 'mouthSmile',
    にっこり: 'mouthSmile',
    '∧': 'mouthFrown',
  },
  visemes: { あ: 'jawOpen', い: 'mouthStretch', う: 'mouthPucker', え: '', お: 'mouthFunnel', ん: '' },
  other: ['瞳小', '瞳大', 'はぁと', '星目', '照れ', '涙', '□', '▲', 'ω', 'ω□', 'はぅ'],
}
