/** An error or a warning about a file. */
export interface Finding {
  severity: 'error' | 'warning'
  code: string
  message: string
  /** JSON pointer into the file. */
  pointer?: string
}

export function errorFinding(code: string, message: string, pointer?: string): Finding {
  return { severity: 'error', code, message, ...(pointer && { pointer }) }
}

export function warningFinding(code: string, message: string, pointer?: string): Finding {
  return { ...errorFinding(code, message, pointer), severity: 'warning' }
}
