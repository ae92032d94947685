package simgsm.web;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;

/** A page that is compressed in parts is one compressed page. */
class PageBodyTest {
    @Test
    void aLargePageIsCompressedRight() throws IOException {
        Random random = new Random(4);
        StringBuilder large = new StringBuilder();
        for (int i = 0; i < 100_000; i++) {
            large.append(random.nextInt(100_000)).append(i % 7 == 0 ? "\u00f1" : " ");
        }
        PageBody body = new PageBody("before", new PageBody.Part(large.toString()), "after");
        try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(body.gzipped()))) {
            assertEquals("before" + large + "after", new String(in.readAllBytes(), StandardCharsets.UTF_8));
        }
    }
}
