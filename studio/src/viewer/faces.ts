import { FurrowError } from 'furrow'
import { checkFileBytes } from 'furrow-files'
import { type OpenedAvatar, openAvatar } from '../open/avatar.ts'

/** Receives the fraction loaded so far, or null if the server does not send the size. */
export type OnProgress = (fraction: number | null) => void

/** Time without received data after which a download fails, milliseconds. */
const TIMEOUT = 30_000

export async function listFaces(): Promise<string[]> {
  const response = await fetch(absoluteUrl('faces/index.json'))
  const names = response.ok ? ((await response.json()) as string[]) : []
  if (names.length > 0) return names
  throw new Error(
    'Studio: no face to show, got an empty faces/, allowed: NAME.glb with wrinkles; build one first',
  )
}

export function fetchFace(name: string, onProgress: OnProgress): Promise<OpenedAvatar> {
  return fetchAvatar(absoluteUrl(`faces/${name}.glb`), onProgress)
}

/**
 * Fetches an avatar from a URL, without credentials and referrer.
 *
 * @throws FurrowError if the avatar cannot be fetched, is too large, or cannot be opened.
 */
export async function fetchAvatar(address: string, onProgress: OnProgress): Promise<OpenedAvatar> {
  const path = fileNameOf(address)
  const blob = await fetchBlob(address, path, onProgress)
  return { ...(await openAvatar({ path, file: new File([blob], path) })), address }
}

export function fileNameOf(address: string): string {
  const name = new URL(address).pathname.split('/').at(-1)!
  try {
    return decodeURIComponent(name) || 'avatar'
  } catch {
    return name
  }
}

function absoluteUrl(path: string): string {
  return new URL(path, document.baseURI).href
}

async function fetchBlob(address: string, name: string, onProgress: OnProgress): Promise<Blob> {
  const stalled = new AbortController()
  let timer = 0
  const wait = () => {
    clearTimeout(timer)
    timer = window.setTimeout(() => stalled.abort(new Error('the server does not answer')), TIMEOUT)
  }
  wait()
  try {
    const options: RequestInit = {
      credentials: 'omit',
      referrerPolicy: 'no-referrer',
      signal: stalled.signal,
    }
    const response = await fetch(address, options)
    if (!response.ok || !response.body) throw new Error(`HTTP status ${response.status}`)
    const length = Number(response.headers.get('Content-Length'))
    const chunks: Uint8Array<ArrayBuffer>[] = []
    const reader = response.body.getReader()
    for (let loaded = 0; ; ) {
      checkFileBytes(Math.max(loaded, length), name, 'Studio')
      const { done, value } = await reader.read()
      if (done) return new Blob(chunks)
      wait()
      chunks.push(value)
      loaded += value.length
      onProgress(length > 0 ? Math.min(loaded / length, 1) : null)
    }
  } catch (error) {
    stalled.abort()
    throw error instanceof FurrowError ? error : fetchError(address, error as Error)
  } finally {
    clearTimeout(timer)
  }
}

function fetchError(address: string, cause: Error): FurrowError {
  return new FurrowError(
    {
      code: 'unreadable',
      who: 'Studio',
      problem: `an avatar cannot be fetched (${cause.message})`,
      value: address,
      remedy:
        'check the connection, and that its server lets other pages read it (CORS); or download it and drop it here',
    },
    { cause },
  )
}
