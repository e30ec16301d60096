export const SOURCES: {
  resolve: { alias: Record<string, string>; conditions: string[] }
  ssr: { resolve: { conditions: string[] } }
}
