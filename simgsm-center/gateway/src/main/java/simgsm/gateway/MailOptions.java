package simgsm.gateway;

import java.net.InetSocketAddress;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import simgsm.air.Msisdn;
import simgsm.console.Arguments;
import simgsm.console.HostPort;
import simgsm.console.UsageException;
import simgsm.gateway.mail.MailSettings;

/**
 * The options of mail.
 *
 * @param smpp the SMSC
 * @param server the mail server for messages from phones
 * @param port of mail from outside; 0 for any free one
 */
record MailOptions(
        InetSocketAddress smpp, MailSettings settings, Optional<InetSocketAddress> server, OptionalInt port) {
    private static final int MAX_PORT = 0xffff;
    private static final String DEFAULT_USER = "mail:";
    private static final String DOMAIN = "[A-Za-z0-9]([A-Za-z0-9.-]{0,251}[A-Za-z0-9])?";

    /** Empty without an option of mail. */
    static Optional<MailOptions> of(Arguments arguments) throws UsageException {
        boolean isUsed = Stream.of("smpp", "smpp-user", "mail-number", "mail-to", "mail-domain", "mail-in")
                .anyMatch(arguments::has);
        if (!isUsed) {
            return Optional.empty();
        }
        for (String needed : new String[] {"smpp", "mail-number", "mail-domain"}) {
            if (!arguments.has(needed)) {
                throw new UsageException(
                        "mail needs --smpp, --mail-number and --mail-domain; --" + needed + " is missing");
            }
        }
        if (!arguments.has("mail-to") && !arguments.has("mail-in")) {
            throw new UsageException("mail needs --mail-to, --mail-in or both");
        }
        String[] user = arguments
                .value("smpp-user", MailOptions::user)
                .orElse(DEFAULT_USER)
                .split(":", 2);
        MailSettings settings = new MailSettings(
                arguments.value("mail-number", Msisdn::new).orElseThrow(),
                arguments.value("mail-domain", MailOptions::domain).orElseThrow(),
                user[0],
                user[1],
                arguments.has("mail-to"));
        return Optional.of(new MailOptions(
                address(arguments.hostPort("smpp").orElseThrow()),
                settings,
                arguments.hostPort("mail-to").map(MailOptions::address),
                arguments.has("mail-in")
                        ? OptionalInt.of((int) arguments.integer("mail-in", 0, 0, MAX_PORT))
                        : OptionalInt.empty()));
    }

    private static InetSocketAddress address(HostPort at) {
        return InetSocketAddress.createUnresolved(at.host(), at.port());
    }

    private static String user(String text) {
        if (!text.matches("[!-9;-~]{1,15}:[!-~]{0,8}")) {
            throw new IllegalArgumentException(
                    "expected ID:PASSWORD with an ID of 1 to 15 and a password of at most 8 characters");
        }
        return text;
    }

    private static String domain(String text) {
        if (!text.matches(DOMAIN)) {
            throw new IllegalArgumentException("expected a domain such as sms.example, found " + text);
        }
        return text;
    }
}
