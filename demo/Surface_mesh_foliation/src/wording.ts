// The engine's messages in the words of the page, which counts loops from 1.

/** `drawn`: the number that the engine gives to the loop that is being drawn. */
export function forPeople(message: string, drawn: number | null = null): string {
  return message.replace(/\bloop (\d+)/g, (_, number: string) =>
    Number(number) === drawn ? 'this loop' : `loop ${Number(number) + 1}`,
  );
}

/** A message as a sentence of its own; a name of a file at its beginning stays as it is. */
export function asSentence(message: string): string {
  const text = /^[a-z]+ /.test(message) ? message.charAt(0).toUpperCase() + message.slice(1) : message;
  return /[.!?)]$/.test(text) ? text : `${text}.`;
}
