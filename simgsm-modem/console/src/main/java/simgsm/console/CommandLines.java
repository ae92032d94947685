package simgsm.console;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.CharacterCodingException;
import simgsm.file.Utf8Text;

/**
 * The command lines of a file or of standard input: UTF-8, with or without a byte order mark, ended by LF, CR LF or
 * CR. A line that is no text is an error; the next line is read.
 */
final class CommandLines implements Console.Lines {
    /** Most octets of a line; the longest command is a message of 255 parts, under 120 000 octets. */
    static final int MAX_OCTETS = 1 << 20;

    /** 10 lines of binary data in a row end the input. */
    static final int MAX_BINARY = 10;

    private final InputStream in;
    private final String name;
    private final ByteArrayOutputStream octets = new ByteArrayOutputStream();
    private long number;
    private long length;
    private int binaryLines;
    private int before;

    /** @param name of the input, for errors */
    CommandLines(String name, InputStream in) {
        this.name = name;
        this.in = new BufferedInputStream(in);
    }

    /** @throws IOException also where the input is binary */
    @Override
    public String next() throws IOException, CommandException {
        if (!readLine()) {
            return null;
        }
        number++;
        try {
            String text = text(octets.toByteArray());
            binaryLines = 0;
            return text;
        } catch (CharacterCodingException e) {
            boolean isBinary = length > MAX_OCTETS || hasControls(octets.toByteArray());
            binaryLines = isBinary ? binaryLines + 1 : 0;
            if (binaryLines == MAX_BINARY) {
                throw new IOException(name + ": expected lines of text, found binary data");
            }
            throw new CommandException(name + ", line " + number + ", " + e.getMessage());
        }
    }

    private String text(byte[] line) throws CharacterCodingException {
        if (length > MAX_OCTETS) {
            throw new NoTextException("expected at most " + MAX_OCTETS + " octets, found " + length);
        }
        for (int i = 0; i < line.length; i++) {
            if (line[i] == 0) {
                throw new NoTextException("octet " + (i + 1) + ": expected text, found 00");
            }
        }
        return Utf8Text.of(line);
    }

    private static boolean hasControls(byte[] line) {
        for (byte octet : line) {
            if (octet >= 0 && octet < ' ' && octet != '\t' && octet != '\f' && octet != 0x1b) {
                return true;
            }
        }
        return false;
    }

    /** @return false at the end of the input */
    private boolean readLine() throws IOException {
        octets.reset();
        length = 0;
        while (true) {
            int octet = in.read();
            if (octet == '\n' && before == '\r') {
                before = octet;
                continue;
            }
            before = octet;
            if (octet < 0) {
                return length > 0;
            }
            if (octet == '\n' || octet == '\r') {
                return true;
            }
            if (++length <= MAX_OCTETS) {
                octets.write(octet);
            }
        }
    }

    private static final class NoTextException extends CharacterCodingException {
        private static final long serialVersionUID = 1;

        private final String text;

        NoTextException(String text) {
            this.text = text;
        }

        @Override
        public String getMessage() {
            return text;
        }
    }
}
