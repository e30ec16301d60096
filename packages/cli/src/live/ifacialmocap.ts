import { type LiveSource, MAX_NAME, MAX_SCORES, type Scores } from './source.ts'

/** Text that a computer sends to port 49983 of the phone, so that the app begins to send. */
export const IFACIALMOCAP_START = 'iFacialMocap_sahuasouryya9218sauhuiayeta91555dy3719'

/**
 * iFacialMocap, for iPhones. Text: `name-value|name-value|...|=head#...|rightEye#...|leftEye#...|` with values 0..100. Its second format and
 * Facemotion3d separate name and value by `&`. Source: https://www.ifacialmocap.com/for-developer/.
 */
export const IFACIALMOCAP: LiveSource = { port: 49983, createReader: () => readPacket }

function readPacket(packet: Uint8Array): Scores | null {
  const [shapes] = new TextDecoder().decode(packet).split('=', 1)
  const entries = shapes.split('|', MAX_SCORES).flatMap((part) => {
    const match = /^([A-Za-z]\w*)\s*[-&]\s*(\d+(?:\.\d+)?)$/.exec(part)
    return match && match[1].length <= MAX_NAME ? [[match[1], Number(match[2]) / 100] as const] : []
  })
  return entries.length > 0 ? Object.fromEntries(entries) : null
}
