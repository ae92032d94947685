package simgsm.web;

import java.net.URLDecoder;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;

/** Encodes and decodes the segments of a URL's path. */
public final class UrlPaths {
    private UrlPaths() {}

    /** A segment, percent-encoded. */
    public static String encoded(String part) {
        return URLEncoder.encode(part, StandardCharsets.UTF_8).replace("+", "%20");
    }

    /** The segments between the slashes, decoded; a trailing slash adds none. */
    static List<String> parts(String rawPath) {
        return Arrays.stream(rawPath.split("/"))
                .skip(1)
                .map(part -> URLDecoder.decode(part.replace("+", "%2B"), StandardCharsets.UTF_8))
                .toList();
    }
}
