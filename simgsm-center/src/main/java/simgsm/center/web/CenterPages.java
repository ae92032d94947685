package simgsm.center.web;

import com.sun.net.httpserver.HttpExchange;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.IntSupplier;
import simgsm.center.msc.Exchange;
import simgsm.web.RequestException;
import simgsm.web.WebPages;
import simgsm.web.WebResponse;

/** The centre's answers by path, each a question to the exchange's thread. */
public final class CenterPages extends WebPages {
    private static final String POLICY = "default-src 'none'";
    private static final String EXPECTED = "/metrics, /subscribers, /calls, /queue or /messages/ID";

    /** Runs questions on the exchange's thread. */
    public interface Questions {
        /** @throws IllegalStateException if the thread does not answer */
        <T> T ask(Function<Exchange, T> question);
    }

    private final Questions questions;
    private final ExchangeReports reports;

    /**
     * Creates the pages of a centre.
     *
     * @param counts belongs to the exchange's thread
     * @param applications counts the bound SMPP sessions, on the exchange's thread
     */
    public CenterPages(Questions questions, EventCounts counts, IntSupplier applications) {
        super(POLICY);
        this.questions = questions;
        reports = new ExchangeReports(counts, applications);
    }

    @Override
    protected Optional<WebResponse> answer(HttpExchange exchange, List<String> parts, String path)
            throws RequestException {
        return Optional.of(answer(parts, path));
    }

    private WebResponse answer(List<String> parts, String path) throws RequestException {
        if (parts.size() == 2 && parts.get(0).equals("messages")) {
            return message(parts.get(1));
        }
        return switch (parts.size() == 1 ? parts.get(0) : "") {
            case "metrics" -> WebResponse.text(MetricsText.TYPE, questions.ask(reports::metrics));
            case "subscribers" -> WebResponse.json(questions.ask(reports::subscribers));
            case "calls" -> WebResponse.json(questions.ask(reports::calls));
            case "queue" -> WebResponse.json(questions.ask(reports::queue));
            default -> throw RequestException.notFound(path, EXPECTED);
        };
    }

    private WebResponse message(String id) throws RequestException {
        if (!id.matches("[0-9]{1,18}")) {
            throw new RequestException(WebResponse.NOT_FOUND, "no message " + id + ", expected a number");
        }
        return questions
                .ask(exchange -> reports.message(exchange, Long.parseLong(id)))
                .map(WebResponse::json)
                .orElseThrow(() -> new RequestException(
                        WebResponse.NOT_FOUND, "no message " + id + ", expected one that waits or has lately ended"));
    }
}
