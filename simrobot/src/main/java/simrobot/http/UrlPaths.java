package simrobot.http;

import java.net.URLDecoder;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;

/** Paths of addresses, part by part, with names of any characters in them. */
final class UrlPaths {
    private UrlPaths() {}

    /** A part as it stands in an address. */
    static String encoded(String part) {
        return URLEncoder.encode(part, StandardCharsets.UTF_8).replace("+", "%20");
    }

    /** The parts between the slashes, decoded; a slash at the end makes no part. */
    static List<String> parts(String rawPath) {
        return Arrays.stream(rawPath.split("/"))
                .skip(1)
                .map(part -> URLDecoder.decode(part.replace("+", "%2B"), StandardCharsets.UTF_8))
                .toList();
    }
}
