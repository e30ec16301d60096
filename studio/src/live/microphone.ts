import { closeDevice, onDisconnect, openDevice } from './media.ts'
import type { StartSource } from './source.ts'

/** Loudness at which the mouth starts to open, and range up to a fully open mouth, decibels. */
const QUIET = -50
const RANGE = 40
/** Time constant with which the mouth follows the loudness, seconds. */
const DELAY = 0.05

/** Opens the mouth by the loudness of a voice. Loud sounds also raise brows and cheeks. */
export const startMicrophone: StartSource = async (_, { onScores, onError }) => {
  const stream = await openDevice('microphone', { audio: true })
  onDisconnect('microphone', stream, onError)
  const context = new AudioContext()
  // The question for access can take longer than the browser counts the click for.
  void context.resume()
  const analyser = context.createAnalyser()
  context.createMediaStreamSource(stream).connect(analyser)
  const samples = new Float32Array(analyser.fftSize)
  let isRunning = true
  let mouth = 0
  let last = performance.now() / 1000
  const read = () => {
    if (!isRunning) return
    analyser.getFloatTimeDomainData(samples)
    const seconds = performance.now() / 1000
    mouth += (loudnessOf(samples) - mouth) * (1 - Math.exp((last - seconds) / DELAY))
    last = seconds
    onScores(scoresOf(mouth), seconds, 'microphone')
    requestAnimationFrame(read)
  }
  requestAnimationFrame(read)
  return {
    stop: () => {
      isRunning = false
      closeDevice(stream)
      void context.close()
    },
  }
}

/** Returns the loudness of a sound, 0..1. */
export function loudnessOf(samples: Float32Array): number {
  const power = samples.reduce((sum, sample) => sum + sample * sample, 0) / samples.length
  return Math.min(1, Math.max(0, (10 * Math.log10(power + 1e-10) - QUIET) / RANGE))
}

/** Returns weights of ARKit's blendshapes for a loudness, 0..1. */
export function scoresOf(loudness: number): Readonly<Record<string, number>> {
  const loud = Math.max(0, loudness - 0.5) * 2
  return {
    jawOpen: 0.7 * loudness,
    mouthUpperUpLeft: 0.6 * loudness,
    mouthUpperUpRight: 0.6 * loudness,
    mouthSmileLeft: 0.35 * loud,
    mouthSmileRight: 0.35 * loud,
    cheekSquintLeft: 0.8 * loud,
    cheekSquintRight: 0.8 * loud,
    browInnerUp: loud,
    browOuterUpLeft: 0.7 * loud,
    browOuterUpRight: 0.7 * loud,
  }
}
