package simgsm.gateway.esme;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import simgsm.timer.Timer;

/** A text under way from the SMSC, and the deliver_sm that wait for its end. */
public final class TextDelivery {
    /** A part of the text, and the latest deliver_sm that brought it. */
    static final class Part {
        final DeliveredText text;
        ApplicationSession session;
        int sequence;

        Part(DeliveredText text, ApplicationSession session, int sequence) {
            this.text = text;
            this.session = session;
            this.sequence = sequence;
        }

        void answer(int status) {
            session.answer(sequence, status);
        }
    }

    private final String number;
    private final String to;
    final List<Part> parts = new ArrayList<>();
    Timer limit;

    TextDelivery(String number, String to) {
        this.number = number;
        this.to = to;
    }

    boolean isWhole() {
        return parts.size() == parts.get(0).text.parts();
    }

    /** The sender's digits. */
    public String number() {
        return number;
    }

    /** The destination's digits: the application's number, or one that begins so. */
    public String to() {
        return to;
    }

    public String text() {
        return parts.stream()
                .sorted(Comparator.comparingInt(part -> part.text.part()))
                .map(part -> part.text.text())
                .collect(Collectors.joining());
    }

    /** Equal whenever the SMSC delivers the text again, and in no other: letters, digits and dots. */
    public String id() {
        return parts.stream()
                .min(Comparator.comparingInt(part -> part.text.part()))
                .orElseThrow()
                .text
                .id();
    }
}
