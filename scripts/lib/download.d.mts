export interface Size {
  gzip: number
  brotli: number
}

export interface Row {
  name: string
  size: Size
  figure: Size | undefined
  hasGrown: boolean
}

export function compareDownload(): Promise<Row[]>
export function compare(sizes: Record<string, Size>, figures: Record<string, Size>): Row[]
export function writeFigures(rows: readonly Row[]): void
export function warnings(rows: readonly Row[]): string[]
export function readFigures(): Record<string, Size>
export function sizeTable(figures: Record<string, Size>): string[]
