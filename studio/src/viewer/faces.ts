import { type OpenedAvatar, openAvatar } from '../open/avatar.ts'

/** Called while a face loads, with the fraction loaded so far; null if the server does not tell the size. */
export type OnProgress = (fraction: number | null) => void

/** Names of the faces on the server. */
export async function listFaces(): Promise<string[]> {
  const response = await fetch(absoluteUrl('faces/index.json'))
  const names = response.ok ? ((await response.json()) as string[]) : []
  if (names.length > 0) return names
  throw new Error(
    'Studio: no face to show, got an empty faces/, allowed: NAME.glb with wrinkles; build one first',
  )
}

export async function fetchFace(name: string, onProgress: OnProgress): Promise<OpenedAvatar> {
  const path = `${name}.glb`
  const blob = await fetchBlob(absoluteUrl(`faces/${path}`), onProgress)
  return openAvatar({ path, file: new File([blob], path) })
}

function absoluteUrl(path: string): string {
  return new URL(path, document.baseURI).href
}

async function fetchBlob(url: string, onProgress: OnProgress): Promise<Blob> {
  const response = await fetch(url)
  if (!response.ok || !response.body) {
    throw new Error(`Studio: face not found, got HTTP status ${response.status} for ${url}; check the server`)
  }
  const length = Number(response.headers.get('Content-Length'))
  const chunks: Uint8Array<ArrayBuffer>[] = []
  const reader = response.body.getReader()
  for (let loaded = 0; ; ) {
    const { done, value } = await reader.read()
    if (done) return new Blob(chunks)
    chunks.push(value)
    loaded += value.length
    onProgress(length > 0 ? Math.min(loaded / length, 1) : null)
  }
}
