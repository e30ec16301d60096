import { decodeHead } from './template-code.ts'
import { TEMPLATES } from './template-data.ts'
import type { TemplateHead } from './templates.ts'

let heads: TemplateHead[] | undefined

/** Returns the built-in template heads, decoded on first call. */
export function templateHeads(): readonly TemplateHead[] {
  heads ??= Object.values(TEMPLATES).map((text) =>
    decodeHead(Uint8Array.from(atob(text), (c) => c.charCodeAt(0))),
  )
  return heads
}
