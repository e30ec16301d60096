/** Message to the worker: URLs of the transcoder's script and WebAssembly, and the bytes of a KTX 2 file. */
export interface TranscodeRequest {
  script: string
  binary: string
  bytes: Uint8Array<ArrayBuffer>
}

/** Message from the worker: the largest mipmap level of all slices as RGBA, or an error message. */
export type Transcoded =
  | { width: number; height: number; slices: Uint8Array<ArrayBuffer>[] }
  | { error: string }

/** Functions of Basis Universal's `basis_transcoder.js` that the worker calls. */
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

/** Code of the worker that decodes KTX 2. The worker runs the text of this function, so the function must not use other code of the module. */
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
    if (!file.isValid() || !file.startTranscoding()) throw new Error('invalid file')
    const slices = Array.from({ length: Math.max(file.getLayers(), 1) }, (_, layer) => {
      const pixels = new Uint8Array(file.getImageTranscodedSizeInBytes(0, layer, 0, RGBA32))
      if (!file.transcodeImage(pixels, 0, layer, 0, RGBA32, 0, -1, -1)) throw new Error('invalid file')
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
      (error) => scope.postMessage({ error: String(error.message ?? error) }),
    )
  }
}
