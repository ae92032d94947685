package simgsm.trace;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.ResourceBundle;
import simgsm.air.Coded;
import simgsm.air.LocationArea;
import simgsm.air.MobileIdentity;
import simgsm.air.TransactionIdentifier;

/** Names and values of fields in a language, Spanish or English. */
final class FieldTexts {
    private static final String BUNDLE = "simgsm.trace.fields";
    private static final FieldTexts ENGLISH = new FieldTexts(Locale.ROOT);
    private static final FieldTexts SPANISH = new FieldTexts(Locale.forLanguageTag("es"));

    private final ResourceBundle bundle;

    private FieldTexts(Locale language) {
        bundle = ResourceBundle.getBundle(BUNDLE, language);
    }

    static FieldTexts in(Locale language) {
        return language.getLanguage().equals("es") ? SPANISH : ENGLISH;
    }

    /** The text of a key with the arguments at {0}, {1} ...; without an entry in the bundle the key itself in words. */
    String of(String key, Object... arguments) {
        String text = bundle.containsKey(key) ? bundle.getString(key) : spaced(key);
        return arguments.length == 0 ? text : new MessageFormat(text, Locale.ROOT).format(arguments);
    }

    /** The value of a component of a message. */
    String value(Object value) {
        if (value instanceof Coded.Titled cause) {
            return cause.code() + " " + cause.title(bundle.getLocale());
        }
        if (value instanceof MobileIdentity identity) {
            return identity.type() + " " + identity;
        }
        if (value instanceof TransactionIdentifier transaction) {
            return transaction.value() + ", " + of(transaction.fromOtherSide() ? "openedByReceiver" : "openedBySender");
        }
        if (value instanceof LocationArea area) {
            return area.countryCode() + "/" + area.networkCode() + " " + of("area") + " " + area.areaCode();
        }
        return value instanceof Enum<?> name ? of(name.name()) : value instanceof Boolean ? of("" + value) : "" + value;
    }

    /** "keySequence" as "key sequence", "IMSI_ATTACH" as "imsi attach". */
    private static String spaced(String key) {
        return key.replaceAll("(?<=[a-z])(?=[A-Z])", " ").replace('_', ' ').toLowerCase(Locale.ROOT);
    }
}
