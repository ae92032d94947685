package simgsm.web;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.util.Map;
import java.util.Objects;
import simgsm.file.Utf8Text;

/** The JSON object in the body of a request. */
public final class JsonBody {
    private JsonBody() {}

    /**
     * Reads a body.
     *
     * @throws RequestException with status 415 for another type, 413 for more octets, 422 if it is no JSON object,
     *     naming the position and the expected syntax
     */
    public static Map<String, Object> read(HttpExchange exchange, int mostOctets) throws IOException, RequestException {
        String type = Objects.requireNonNullElse(exchange.getRequestHeaders().getFirst("Content-Type"), "");
        if (!type.split(";", 2)[0].strip().equalsIgnoreCase("application/json")) {
            throw new RequestException(
                    WebResponse.UNSUPPORTED_TYPE,
                    "expected Content-Type: application/json, found "
                            + (type.isEmpty() ? "none" : RequestException.shortened(type)));
        }
        byte[] octets = exchange.getRequestBody().readNBytes(mostOctets + 1);
        if (octets.length > mostOctets) {
            throw new RequestException(
                    WebResponse.CONTENT_TOO_LARGE, "expected at most " + mostOctets + " octets, found more");
        }
        try {
            return JsonReader.object(Utf8Text.of(octets));
        } catch (IllegalArgumentException | CharacterCodingException e) {
            throw new RequestException(WebResponse.UNPROCESSABLE, e.getMessage());
        }
    }
}
