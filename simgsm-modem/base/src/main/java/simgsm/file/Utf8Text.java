package simgsm.file;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Text written by users with any editor: UTF-8, with or without a byte order mark. Nothing is replaced: an octet that
 * is not UTF-8 is an error that names the octet and its place.
 */
public final class Utf8Text {
    private static final char BYTE_ORDER_MARK = '\uFEFF';

    private Utf8Text() {}

    /**
     * The text of a file.
     *
     * @throws IOException naming the file, and the line of an octet that is not UTF-8
     */
    public static String read(Path file) throws IOException {
        byte[] octets = FileErrors.naming(file, () -> Files.readAllBytes(file));
        try {
            return of(octets);
        } catch (CharacterCodingException e) {
            throw new IOException(file + ": " + e.getMessage(), e);
        }
    }

    /**
     * The text of octets.
     *
     * @throws CharacterCodingException naming the first octet that is not UTF-8, its line and column
     */
    public static String of(byte[] octets) throws CharacterCodingException {
        CharsetDecoder decoder = StandardCharsets.UTF_8.newDecoder();
        ByteBuffer in = ByteBuffer.wrap(octets);
        CharBuffer out = CharBuffer.allocate(octets.length + 1);
        CoderResult result = decoder.decode(in, out, true);
        if (result.isError()) {
            throw new NotUtf8Exception(octets, in.position());
        }
        String text = out.flip().toString();
        return !text.isEmpty() && text.charAt(0) == BYTE_ORDER_MARK ? text.substring(1) : text;
    }

    private static final class NotUtf8Exception extends CharacterCodingException {
        private static final long serialVersionUID = 1;

        private final String text;

        NotUtf8Exception(byte[] octets, int at) {
            int line = 1;
            int lineStart = 0;
            for (int i = 0; i < at; i++) {
                if (octets[i] == '\n') {
                    line++;
                    lineStart = i + 1;
                }
            }
            text = (line == 1 ? "" : "line " + line + ", ") + "octet " + (at - lineStart + 1)
                    + String.format(": expected UTF-8, found %02X", octets[at] & 0xff);
        }

        @Override
        public String getMessage() {
            return text;
        }
    }
}
