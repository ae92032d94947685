package vericommand;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;

/** Recognises the replies of this suite in both languages, so that robots do not answer one another. */
final class ReplyForms {
    private static final Map<ReplyTone, List<String>> KEYS = Map.of(
            ReplyTone.CONNECTION_DENIED, List.of("reply.denied"),
            ReplyTone.EXECUTED, List.of("reply.done", "reply.done.many"),
            ReplyTone.COLLISION, List.of("reply.collision", "reply.process.collision", "reply.where"),
            ReplyTone.INFINITE_LOOP, List.of("reply.loop", "reply.process.failed"),
            ReplyTone.EXECUTING, List.of("reply.executing", "reply.process.started"),
            ReplyTone.NOT_VALID, List.of("reply.invalid", "reply.process.none"),
            ReplyTone.NOT_POSSIBLE, List.of("reply.impossible", "reply.stopped", "reply.stopped.trip"));

    /** Placeholder of an argument; no text has it. */
    private static final String ARGUMENT = "\0";

    /** The fixed parts of each reply, in order; a message begins with the first. */
    private static final List<List<String>> FORMS = Stream.of(Locale.ENGLISH, Locale.forLanguageTag("es"))
            .flatMap(locale -> KEYS.entrySet().stream()
                    .flatMap(tone -> tone.getValue().stream().map(key -> parts(locale, tone.getKey(), key))))
            .toList();

    private ReplyForms() {}

    private static List<String> parts(Locale locale, ReplyTone tone, String key) {
        String text = VeriCommandTexts.text(locale, key, ARGUMENT, ARGUMENT, ARGUMENT, ARGUMENT);
        return List.of((tone.number() + " " + text).split(ARGUMENT));
    }

    /** True if a message is a reply: the tone's digit, then its text, then anything. */
    static boolean isReply(String message) {
        String text = message.strip();
        return FORMS.stream().anyMatch(parts -> fits(text, parts));
    }

    private static boolean fits(String text, List<String> parts) {
        if (!text.startsWith(parts.get(0))) {
            return false;
        }
        int read = parts.get(0).length();
        for (String part : parts.subList(1, parts.size())) {
            int found = text.indexOf(part, read);
            if (found < 0) {
                return false;
            }
            read = found + part.length();
        }
        return true;
    }
}
