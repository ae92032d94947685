package simgsm.web;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Objects;
import java.util.regex.Pattern;
import java.util.zip.CRC32;
import java.util.zip.Deflater;

/** A page of three parts; the large middle one seldom changes, and its compressed form is cached. */
public final class PageBody {
    /** RFC 1952, 2.3: deflated, no time, no name, unknown system. */
    private static final byte[] GZIP_HEAD = {0x1f, (byte) 0x8b, 8, 0, 0, 0, 0, 0, 0, (byte) 0xff};

    private static final String TYPE = "text/html; charset=utf-8";
    private static final Pattern ACCEPTS_GZIP =
            Pattern.compile("(^|[ ,])(gzip|\\*)($|[ ,]|;(?!\\s*q=0(\\.0*)?\\s*($|,)))");

    /** A text, and its octets deflated by RFC 1951 into blocks without the final one. */
    public static final class Part {
        private final byte[] octets;
        private final byte[] deflated;

        public Part(String text) {
            octets = text.getBytes(StandardCharsets.UTF_8);
            deflated = deflated(octets, false);
        }
    }

    private final byte[] before;
    private final Part middle;
    private final byte[] after;
    private final long checksum;

    public PageBody(String before, Part middle, String after) {
        this.before = before.getBytes(StandardCharsets.UTF_8);
        this.middle = middle;
        this.after = after.getBytes(StandardCharsets.UTF_8);
        CRC32 sum = new CRC32();
        sum.update(this.before);
        sum.update(middle.octets);
        sum.update(this.after);
        checksum = sum.getValue();
    }

    private static byte[] deflated(byte[] octets, boolean last) {
        Deflater deflater = new Deflater(last ? Deflater.BEST_SPEED : Deflater.DEFAULT_COMPRESSION, true);
        try {
            deflater.setInput(octets);
            if (last) {
                deflater.finish();
            }
            ByteArrayOutputStream out = new ByteArrayOutputStream(octets.length / 4 + 64);
            byte[] some = new byte[8192];
            int size = some.length;
            while (size == some.length) {
                size = deflater.deflate(some, 0, some.length, last ? Deflater.NO_FLUSH : Deflater.SYNC_FLUSH);
                out.write(some, 0, size);
            }
            return out.toByteArray();
        } finally {
            deflater.end();
        }
    }

    private byte[] octets() {
        return joined(before, middle.octets, after);
    }

    /** The page compressed by RFC 1952. Only the small parts are compressed now. */
    byte[] gzipped() {
        byte[] tail = ByteBuffer.allocate(8)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putInt((int) checksum)
                .putInt(before.length + middle.octets.length + after.length)
                .array();
        return joined(GZIP_HEAD, deflated(before, false), middle.deflated, deflated(after, true), tail);
    }

    /** An entity tag, RFC 9110, 8.8.3: the same for the same text. */
    String tag() {
        return "W/\"" + Long.toHexString(checksum) + "-" + (before.length + middle.octets.length + after.length) + "\"";
    }

    /** The answer to a request: nothing if the client has this page already, compressed if it accepts that. */
    public WebResponse answer(HttpExchange exchange) {
        Headers asked = exchange.getRequestHeaders();
        Headers headers = exchange.getResponseHeaders();
        headers.set("ETag", tag());
        headers.add("Vary", "Accept-Encoding");
        if (tag().equals(asked.getFirst("If-None-Match"))) {
            return new WebResponse(WebResponse.NOT_MODIFIED, TYPE, new byte[0]);
        }
        String encodings = Objects.requireNonNullElse(asked.getFirst("Accept-Encoding"), "");
        if (!ACCEPTS_GZIP.matcher(encodings).find()) {
            return new WebResponse(WebResponse.OK, TYPE, octets());
        }
        headers.set("Content-Encoding", "gzip");
        return new WebResponse(WebResponse.OK, TYPE, gzipped());
    }

    private static byte[] joined(byte[]... parts) {
        ByteBuffer all = ByteBuffer.allocate(
                Arrays.stream(parts).mapToInt(part -> part.length).sum());
        for (byte[] part : parts) {
            all.put(part);
        }
        return all.array();
    }
}
