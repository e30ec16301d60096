export interface ExamplePage {
  name: string
  source: string
  title: string
  description: string
  keywords: string
  group: string
}

export const GROUPS: readonly string[]
export function exampleNames(): string[]
export function readExample(name: string): ExamplePage
export function readExamples(): ExamplePage[]
