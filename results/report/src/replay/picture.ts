// The picture of the replay with what it shows written below, as a PNG.

const kLine = 24; // [px]

export interface Key {
  label: string;
  color: string;
}

export function pictureOf(canvas: HTMLCanvasElement, lines: string[], keys: Key[], dark: boolean): Promise<Blob> {
  const copy = document.createElement("canvas");
  copy.width = canvas.width;
  copy.height = canvas.height + (lines.length + 1) * kLine + 12;
  const pen = copy.getContext("2d");
  if (!pen) return Promise.reject(new Error("This browser makes no pictures of a canvas."));
  pen.fillStyle = dark ? "#161b21" : "#ffffff";
  pen.fillRect(0, 0, copy.width, copy.height);
  pen.drawImage(canvas, 0, 0);
  pen.fillStyle = dark ? "#e6e9ec" : "#1c2126";
  pen.font = "16px sans-serif";
  lines.forEach((line, i) => pen.fillText(line, 10, canvas.height + kLine * (i + 1) - 3, copy.width - 20));
  drawKeys(pen, keys, canvas.height + kLine * (lines.length + 1) - 3);
  return new Promise((resolve, reject) => {
    copy.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("The picture could not be made."))), "image/png");
  });
}

// In one row.
function drawKeys(pen: CanvasRenderingContext2D, keys: Key[], y: number): void {
  const text = pen.fillStyle;
  pen.font = "13px sans-serif";
  let x = 10;
  for (const { label, color } of keys) {
    pen.fillStyle = color;
    pen.fillRect(x, y - 9, 16, 8);
    pen.fillStyle = text;
    pen.fillText(label, x + 21, y);
    x += 21 + pen.measureText(label).width + 14;
  }
}

export function download(blob: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
