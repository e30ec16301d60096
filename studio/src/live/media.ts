import { FurrowError } from 'furrow'

/** Device that the browser asks the user for. */
export type Device = 'camera' | 'microphone'

/** Asks for access to a device. Rejects with a FurrowError that tells what to do. */
export async function openDevice(device: Device, constraints: MediaStreamConstraints): Promise<MediaStream> {
  if (!navigator.mediaDevices) {
    throw deviceError(
      'the browser offers no camera and no microphone here',
      'open this page by https or on localhost',
    )
  }
  try {
    return await navigator.mediaDevices.getUserMedia(constraints)
  } catch (cause) {
    const { name, message } = cause as DOMException
    if (name === 'NotAllowedError') {
      throw deviceError(
        `access to the ${device} was refused`,
        'allow it beside the address of this page, then start again',
        cause,
      )
    }
    if (name === 'NotFoundError')
      throw deviceError(`no ${device} was found`, 'connect one, then start again', cause)
    if (name === 'NotReadableError') {
      throw deviceError(
        `the ${device} does not answer`,
        'close other programs that use it, then start again',
        cause,
      )
    }
    throw deviceError(`the ${device} cannot be used (${message})`, `try another ${device}`, cause)
  }
}

/** Releases a device. */
export function closeDevice(stream: MediaStream): void {
  for (const track of stream.getTracks()) track.stop()
}

/** Calls a function when the device is disconnected. */
export function onDisconnect(device: Device, stream: MediaStream, call: (error: FurrowError) => void): void {
  for (const track of stream.getTracks()) {
    track.addEventListener('ended', () =>
      call(deviceError(`the ${device} was disconnected`, 'connect it, then start again')),
    )
  }
}

function deviceError(problem: string, remedy: string, cause?: unknown): FurrowError {
  return new FurrowError({ code: 'unsupported', who: 'Studio', problem, remedy }, { cause })
}
