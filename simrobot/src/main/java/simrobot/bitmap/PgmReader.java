package simrobot.bitmap;

/** Reads PGM, the grey picture format of Netpbm, plain (P2) or binary (P5), with 8 or 16 bits. */
final class PgmReader {
    private final String source;
    private final byte[] octets;
    private int at = 2;

    private PgmReader(String source, byte[] octets) {
        this.source = source;
        this.octets = octets;
    }

    static boolean isOne(byte[] octets) {
        return octets.length > 2 && octets[0] == 'P' && (octets[1] == '2' || octets[1] == '5');
    }

    static GrayPicture read(String source, byte[] octets) throws PictureFormatException {
        PgmReader reader = new PgmReader(source, octets);
        int width = reader.number("the width", 1, GrayPicture.MOST_PIXELS);
        int height = reader.number("the height", 1, GrayPicture.MOST_PIXELS / width);
        int white = reader.number("the value of white", 1, 65_535);
        byte[] gray = new byte[width * height];
        if (octets[1] == '2') {
            for (int i = 0; i < gray.length; i++) {
                gray[i] = (byte) (reader.number("a pixel", 0, white) * 255 / white);
            }
        } else {
            reader.binary(gray, white);
        }
        return new GrayPicture(width, height, gray);
    }

    /** One blank ends the head. */
    private void binary(byte[] gray, int white) throws PictureFormatException {
        at++;
        int size = white > 255 ? 2 : 1;
        if (octets.length - at < (long) gray.length * size) {
            throw new PictureFormatException(
                    source,
                    "found " + (octets.length - at) + " octets of pixels, expected " + (long) gray.length * size);
        }
        for (int i = 0; i < gray.length; i++) {
            int value = octets[at++] & 0xff;
            if (size == 2) {
                value = value << 8 | octets[at++] & 0xff;
            }
            gray[i] = (byte) (Math.min(value, white) * 255 / white);
        }
    }

    private int number(String what, int least, int most) throws PictureFormatException {
        while (at < octets.length && (octets[at] <= ' ' || octets[at] == '#')) {
            if (octets[at] == '#') {
                while (at < octets.length && octets[at] != '\n') {
                    at++;
                }
            } else {
                at++;
            }
        }
        long value = -1;
        while (at < octets.length && octets[at] >= '0' && octets[at] <= '9') {
            value = Math.min(Integer.MAX_VALUE, Math.max(0, value) * 10 + octets[at++] - '0');
        }
        if (value < least || value > most) {
            throw new PictureFormatException(
                    source,
                    "found " + (value < 0 ? "no number" : "" + value) + " for " + what + ", expected " + least + " to "
                            + most);
        }
        return (int) value;
    }
}
