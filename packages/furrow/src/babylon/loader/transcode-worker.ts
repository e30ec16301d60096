/** What a worker is asked for: addresses of the transcoder, and a KTX 2 file. */
export interface TranscodeRequest {
  script: string
  binary: string
  bytes: Uint8Array<ArrayBuffer>
}

/** The largest level of all slices in RGBA, or what went wrong. */
export type Transcoded =
  | { width: number; height: number; slices: Uint8Array<ArrayBuffer>[] }
  | { fault: string }

/** What is used of the transcoder of Basis Universal, `basis_transcoder.js`. */
interface BasisModule {
  initializeBasis(): void
  KTX2File: new (
    bytes: Uint8Array,
  ) => {
    isValid(): boolean
    getWidth(): number
    getHeight(): number
    getLayers(): number
    startTranscoding(): boolean
    getImageTranscodedSizeInBytes(level: number, layer: number, face: number, format: number): number
    transcodeImage(
      to: Uint8Array,
      level: number,
      layer: number,
      face: number,
      format: number,
      getAlphaForOpaqueFormats: number,
      channel0: number,
      channel1: number,
    ): boolean
  }
}

/** The whole of a worker, which is started from this function's text: it may use nothing around it. */
export function transcodeInWorker(): void {
  const RGBA32 = 13
  const scope = self as unknown as {
    importScripts(address: string): void
    BASIS(options: { wasmBinary: ArrayBuffer }): Promise<BasisModule>
    postMessage(message: unknown, transfer?: ArrayBuffer[]): void
    onmessage: (event: { data: TranscodeRequest }) => void
  }
  const transcode = async ({ script, binary, bytes }: TranscodeRequest) => {
    scope.importScripts(script)
    const response = await fetch(binary)
    if (!response.ok) throw new Error(`${binary} cannot be fetched`)
    const basis = await scope.BASIS({ wasmBinary: await response.arrayBuffer() })
    basis.initializeBasis()
    const file = new basis.KTX2File(bytes)
    if (!file.isValid() || !file.startTranscoding()) throw new Error('it is damaged')
    const slices = Array.from({ length: Math.max(file.getLayers(), 1) }, (_, layer) => {
      const pixels = new Uint8Array(file.getImageTranscodedSizeInBytes(0, layer, 0, RGBA32))
      if (!file.transcodeImage(pixels, 0, layer, 0, RGBA32, 0, -1, -1)) throw new Error('it is damaged')
      return pixels
    })
    return { width: file.getWidth(), height: file.getHeight(), slices }
  }
  scope.onmessage = ({ data }) => {
    transcode(data).then(
      (image) =>
        scope.postMessage(
          image,
          image.slices.map(({ buffer }) => buffer),
        ),
      (error) => scope.postMessage({ fault: String(error.message ?? error) }),
    )
  }
}
