/** The part of the Khronos validator that is used here; the package brings no types. */
declare module 'gltf-validator' {
  export interface Issue {
    code: string
    message: string
    /** 0 = error, 1 = warning, 2 = information, 3 = hint. */
    severity: number
    pointer?: string
  }

  export function validateBytes(
    data: Uint8Array,
    options?: {
      maxIssues?: number
      /** Reads a file beside the glTF file by its address. */
      externalResourceFunction?: (uri: string) => Promise<Uint8Array>
    },
  ): Promise<{ issues: { numErrors: number; numWarnings: number; messages: Issue[] } }>
}
