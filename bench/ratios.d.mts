export function measureTwice(figures: Record<string, number>): Promise<Record<string, number>>
export function readFigures(): Record<string, number>
export function writeFigures(ratios: Record<string, number>): void
export function warnings(ratios: Record<string, number>, figures: Record<string, number>): string[]
