import { afterEach, beforeEach, type MockInstance, vi } from 'vitest'

type Spy = MockInstance<(...parts: unknown[]) => void>

/** Warnings and errors of the current test, which are not printed; to be called where tests are described. */
export function quietConsole(): { readonly warn: Spy; readonly error: Spy } {
  const spies = {} as { warn: Spy; error: Spy }
  beforeEach(() => {
    spies.warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    spies.error = vi.spyOn(console, 'error').mockImplementation(() => {})
  })
  afterEach(() => void vi.restoreAllMocks())
  return spies
}
