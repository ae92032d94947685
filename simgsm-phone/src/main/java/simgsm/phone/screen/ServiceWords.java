package simgsm.phone.screen;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.UnaryOperator;
import simgsm.ss.ServiceStatus;

/** The network's answer about a supplementary service, in words. */
public final class ServiceWords {
    private ServiceWords() {}

    public static Words title(ServiceStatus status) {
        return Words.of("service." + status.service().name().toLowerCase(Locale.ROOT));
    }

    /** How the service stands. */
    public static Words state(ServiceStatus status) {
        return Words.of(
                status.isActive()
                        ? "service.active"
                        : status.isRegistered() ? "service.registered" : "service.inactive");
    }

    /** How the service stands, and the number to which calls are forwarded. @param names the name of a number */
    static List<Words> lines(ServiceStatus status, UnaryOperator<String> names) {
        List<Words> lines = new ArrayList<>();
        lines.add(state(status));
        status.forwardedTo().ifPresent(number -> lines.add(Words.of("service.to", names.apply(number))));
        return lines;
    }
}
