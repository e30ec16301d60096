export const MINI_BROWSER: string

export const PROGRAMS: Record<'firefox' | 'webkit', Record<string, string>>

export function missingPackages(browser: 'firefox' | 'webkit'): string[]
