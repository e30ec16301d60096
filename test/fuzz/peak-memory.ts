import { readFileSync } from 'node:fs'

/**
 * Largest resident memory of this process, in bytes. On Linux `maxRSS` begins with the memory of the process that started this one, so the
 * kernel's figure for this program alone is read instead (`VmHWM`, proc(5)).
 */
export function peakMemory(): number {
  const [, kilobytes] = process.platform === 'linux' ? (/^VmHWM:\s*(\d+)/m.exec(ownStatus()) ?? []) : []
  return 1024 * Number(kilobytes ?? process.resourceUsage().maxRSS)
}

function ownStatus(): string {
  return readFileSync('/proc/self/status', 'utf8')
}
