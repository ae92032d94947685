package simgsm.gateway;

import java.net.InetSocketAddress;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import simgsm.air.Msisdn;
import simgsm.console.Arguments;
import simgsm.console.UsageException;
import simgsm.gateway.mail.MailSettings;

/**
 * The options of mail.
 *
 * @param server the mail server for messages from phones
 * @param port of mail from outside; 0 for any free one
 */
record MailOptions(SmppOptions smpp, MailSettings settings, Optional<InetSocketAddress> server, OptionalInt port) {
    private static final int MAX_PORT = 0xffff;
    private static final String DOMAIN = "[A-Za-z0-9]([A-Za-z0-9.-]{0,251}[A-Za-z0-9])?";

    /** Empty without an option of mail. */
    static Optional<MailOptions> of(Arguments arguments) throws UsageException {
        Stream<String> own = Stream.of("mail-number", "mail-to", "mail-domain", "mail-in");
        Stream<String> shared = FaxOptions.isUsed(arguments) ? Stream.of() : Stream.of("smpp", "smpp-user");
        if (Stream.concat(own, shared).noneMatch(arguments::has)) {
            return Optional.empty();
        }
        SmppOptions smpp = SmppOptions.of(arguments, "mail", "smpp", "mail-number", "mail-domain");
        if (!arguments.has("mail-to") && !arguments.has("mail-in")) {
            throw new UsageException("mail needs --mail-to, --mail-in or both");
        }
        Msisdn number = arguments.value("mail-number", MailOptions::number).orElseThrow();
        MailSettings settings = new MailSettings(
                smpp.bind(number, "^" + number),
                arguments.value("mail-domain", MailOptions::domain).orElseThrow(),
                arguments.has("mail-to"),
                PageWords.own(arguments.language()));
        return Optional.of(new MailOptions(
                smpp,
                settings,
                arguments.hostPort("mail-to").map(SmppOptions::address),
                arguments.has("mail-in")
                        ? OptionalInt.of((int) arguments.integer("mail-in", 0, 0, MAX_PORT))
                        : OptionalInt.empty()));
    }

    private static Msisdn number(String text) {
        Msisdn number = new Msisdn(text);
        if (text.length() > MailSettings.MOST_DIGITS) {
            throw new IllegalArgumentException("expected at most " + MailSettings.MOST_DIGITS
                    + " digits, as each mail has a number of 4 to 8 more, found " + text);
        }
        return number;
    }

    private static String domain(String text) {
        if (!text.matches(DOMAIN)) {
            throw new IllegalArgumentException("expected a domain such as sms.example, found " + text);
        }
        return text;
    }
}
