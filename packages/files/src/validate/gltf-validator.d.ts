/** Types for the functions of the Khronos validator that this package calls. The npm package has no types. */
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
      /** Reads an external file by its URI. */
      externalResourceFunction?: (uri: string) => Promise<Uint8Array>
    },
  ): Promise<{ issues: { numErrors: number; numWarnings: number; messages: Issue[] } }>
}
