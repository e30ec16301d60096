import { decodeHead } from './template-code.ts'
import { TEMPLATES } from './template-data.ts'
import type { TemplateHead } from './templates.ts'

let heads: TemplateHead[] | undefined

/** Typical heads that shapes are compared with. Decoded at the first call. */
export function templateHeads(): readonly TemplateHead[] {
  heads ??= Object.values(TEMPLATES).map((text) =>
    decodeHead(Uint8Array.from(atob(text), (c) => c.charCodeAt(0))),
  )
  return heads
}
