package simgsm.phone.screen;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.UnaryOperator;
import simgsm.ss.ServiceStatus;
import simgsm.ss.SsError;
import simgsm.station.context.StationEvent;

/** The network's answer about a supplementary service, in words. */
public final class ServiceWords {
    private ServiceWords() {}

    public static Words title(ServiceStatus status) {
        return Words.of("service." + status.service().name().toLowerCase(Locale.ROOT));
    }

    /** The state of the service. */
    public static Words state(ServiceStatus status) {
        return Words.of(
                status.isActive()
                        ? "service.active"
                        : status.isRegistered() ? "service.registered" : "service.inactive");
    }

    /** The state of the service, and the number to which calls are forwarded. @param names the name of a number */
    static List<Words> lines(ServiceStatus status, UnaryOperator<String> names) {
        List<Words> lines = new ArrayList<>();
        lines.add(state(status));
        status.forwardedTo().ifPresent(number -> lines.add(Words.of("service.to", names.apply(number))));
        status.noReplySeconds().ifPresent(seconds -> lines.add(Words.of("service.after", seconds)));
        return lines;
    }

    /** The reason for a dialogue's end without an answer; empty if the user ended it or has read the answer. */
    public static Optional<Screen.Note> noteOf(StationEvent.UssdEnded end) {
        return switch (end.how()) {
            case COMPLETED, CANCELLED -> Optional.empty();
            case REFUSED -> Optional.of(refusal(end.error()));
            case NO_SERVICE -> Optional.of(new Screen.Note(Screen.Note.Kind.USSD_NO_SERVICE, ""));
            case ENDED_BY_NETWORK, NO_ANSWER -> Optional.of(new Screen.Note(Screen.Note.Kind.USSD_NO_ANSWER, ""));
        };
    }

    private static Screen.Note refusal(Optional<SsError> error) {
        return error.equals(Optional.of(SsError.UNEXPECTED_DATA_VALUE))
                ? new Screen.Note(Screen.Note.Kind.USSD_UNKNOWN, "")
                : new Screen.Note(
                        Screen.Note.Kind.USSD_REFUSED,
                        error.map(known -> String.valueOf(known.code())).orElse(""));
    }
}
