package simrobot.http;

import java.net.URLDecoder;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;

/** The parts of a URL's path, percent-encoded and decoded. */
final class UrlPaths {
    private UrlPaths() {}

    /** A part as it stands in a URL. */
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
