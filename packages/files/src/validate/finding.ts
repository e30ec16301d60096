export interface Finding {
  severity: 'error' | 'warning'
  code: string
  message: string
  /** JSON pointer to the faulty part of the file (RFC 6901). */
  pointer?: string
}

export function errorFinding(code: string, message: string, pointer?: string): Finding {
  return { severity: 'error', code, message, ...(pointer && { pointer }) }
}

export function warningFinding(code: string, message: string, pointer?: string): Finding {
  return { ...errorFinding(code, message, pointer), severity: 'warning' }
}
