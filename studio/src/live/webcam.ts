import { FurrowError } from 'furrow'
import type { FaceScore } from 'furrow/three'
import { closeDevice, onDisconnect, openDevice } from './media.ts'
import type { StartSource } from './source.ts'

/** Part of MediaPipe's `FaceLandmarker` that this page uses. */
interface Landmarker {
  detectForVideo(
    video: HTMLVideoElement,
    milliseconds: number,
  ): { faceBlendshapes: { categories: FaceScore[] }[] }
  close(): void
}

/** Reads scores from a camera with MediaPipe (Apache 2.0), which the browser downloads here. Pictures stay in this page. */
export const startWebcam: StartSource = async ({ library, model }, { onScores, onStatus, onError }) => {
  // Ask for the camera first, because a refusal makes the download useless.
  const stream = await openDevice('camera', { video: { width: 640, height: 480 } })
  try {
    const landmarker = await loadLandmarker(library, model)
    const video = Object.assign(document.createElement('video'), { muted: true, playsInline: true })
    video.srcObject = stream
    await video.play()
    onDisconnect('camera', stream, onError)
    let isRunning = true
    const next = () => {
      if (!isRunning) return
      if (video.requestVideoFrameCallback) video.requestVideoFrameCallback(read)
      else requestAnimationFrame(read)
    }
    const read = () => {
      if (!isRunning) return
      try {
        const milliseconds = performance.now()
        const scores = landmarker.detectForVideo(video, milliseconds).faceBlendshapes[0]?.categories
        if (scores) onScores(scores, milliseconds / 1000, 'webcam')
        else onStatus('noFace')
        next()
      } catch (error) {
        onError(mediaPipeError('MediaPipe', library, error))
      }
    }
    onStatus('noFace')
    next()
    return {
      stop: () => {
        isRunning = false
        closeDevice(stream)
        landmarker.close()
      },
    }
  } catch (error) {
    closeDevice(stream)
    throw error
  }
}

async function loadLandmarker(library: string, model: string): Promise<Landmarker> {
  const { FaceLandmarker, FilesetResolver } = await import(
    /* @vite-ignore */ `${library}/vision_bundle.mjs`
  ).catch((cause) => {
    throw mediaPipeError('MediaPipe', library, cause)
  })
  const bytes = await fetchModel(model).catch((cause) => {
    throw mediaPipeError("MediaPipe's model", model, cause)
  })
  try {
    return await FaceLandmarker.createFromOptions(await FilesetResolver.forVisionTasks(`${library}/wasm`), {
      baseOptions: { modelAssetBuffer: bytes, delegate: 'GPU' },
      runningMode: 'VIDEO',
      outputFaceBlendshapes: true,
    })
  } catch (cause) {
    throw mediaPipeError('MediaPipe', library, cause)
  }
}

async function fetchModel(address: string): Promise<Uint8Array> {
  const response = await fetch(address)
  if (!response.ok) throw new Error(`status ${response.status}`)
  return new Uint8Array(await response.arrayBuffer())
}

function mediaPipeError(part: string, address: string, cause: unknown): FurrowError {
  const problem = `${part} cannot be used (${(cause as Error)?.message ?? cause})`
  const remedy = 'check the connection and the address in the settings of the webcam'
  return new FurrowError({ code: 'unreadable', who: 'Studio', problem, value: address, remedy }, { cause })
}
