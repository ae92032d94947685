package simgsm.gateway;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import simgsm.web.JsonText;
import simgsm.web.QrCode;
import simgsm.web.RequestException;
import simgsm.web.WebPages;
import simgsm.web.WebResponse;

/** The pages' files, for everybody; the robots' pictures and states, with the key. */
final class GatewayPages extends WebPages {
    /** Permits scripts and styles of this port only; pictures also from the script, which fetches them with the key. */
    private static final String POLICY = "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self';"
            + " img-src 'self' blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

    private static final String SCRIPT = "text/javascript; charset=utf-8";

    private static final Map<String, String> TYPES = Map.of(
            "index.html", "text/html; charset=utf-8",
            "icon.svg", "image/svg+xml",
            "link.html", "text/html; charset=utf-8",
            "link.js", SCRIPT,
            "phone.css", "text/css; charset=utf-8",
            "phone.js", SCRIPT,
            "sound.js", SCRIPT);

    private final Gateway gateway;
    private final RobotPages robots;

    GatewayPages(Gateway gateway, RobotPages robots) {
        super(POLICY, true);
        this.gateway = gateway;
        this.robots = robots;
    }

    @Override
    protected Optional<WebResponse> answer(HttpExchange exchange, List<String> parts, String path)
            throws IOException, RequestException {
        String first = parts.isEmpty() ? "index.html" : parts.get(0);
        if (parts.size() <= 1 && TYPES.containsKey(first)) {
            try (InputStream in = GatewayPages.class.getResourceAsStream("page-files/" + first)) {
                return Optional.of(new WebResponse(WebResponse.OK, TYPES.get(first), in.readAllBytes()));
            }
        }
        if (parts.size() == 1 && (first.equals("words-en.json") || first.equals("words-es.json"))) {
            Locale language = Locale.forLanguageTag(first.substring(6, 8));
            return Optional.of(WebResponse.json(new PageWords(language).json()));
        }
        if (!List.of("robots", "link.svg", "users").contains(first)) {
            throw RequestException.notFound(path, "/, /link.html or /robots");
        }
        operator(exchange, gateway.users().keys());
        return Optional.of(
                switch (first) {
                    case "robots" -> robots.answer(parts.subList(1, parts.size()), path);
                    case "users" -> WebResponse.json(users());
                    default -> WebResponse.text("image/svg+xml", code(gateway.link()));
                });
    }

    private String users() {
        JsonText json = new JsonText().open('[');
        gateway.ask(() ->
                        gateway.users().all().stream().filter(WebUser::hasPage).toList())
                .forEach(user -> {
                    json.open('{').name("number").value(user.number().toString());
                    json.name("name").value(user.name()).close('}');
                });
        return json.close(']').toString();
    }

    private static String code(String link) {
        QrCode code = new QrCode(link);
        int side = code.size() + 2 * QrCode.QUIET_ZONE;
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + side + " " + side + "\" aria-label=\""
                + link + "\"><rect width=\"100%\" height=\"100%\" fill=\"#fff\"/><path d=\"" + code.svgPath()
                + "\"/></svg>";
    }
}
