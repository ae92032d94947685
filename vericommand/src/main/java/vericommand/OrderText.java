package vericommand;

/**
 * Reads the one order of a short message or a command line by the recogniser of calls. Keys before the opening or
 * after the closing, ignored in a call, are faults here.
 */
public final class OrderText {
    private OrderText() {}

    /** The text without blanks and line breaks. */
    public static String keysOf(String text) {
        return text.codePoints()
                .filter(character -> !Character.isWhitespace(character) && character != 0xa0)
                .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
                .toString();
    }

    /** @return complete or broken, never pending; a fault has all keys of the text */
    public static Recognition read(String text) {
        String keys = keysOf(text);
        CommandRecognizer recognizer = new CommandRecognizer();
        for (int i = 0; i < keys.length(); i++) {
            char key = keys.charAt(i);
            if (i < 2 && key != '*') {
                return broken(keys, i + 1, i == 0 ? ExpectedKeys.OPENING : ExpectedKeys.STAR);
            }
            Recognition recognition = recognizer.key(key);
            if (recognition instanceof Recognition.Broken broken) {
                return broken(keys, broken.fault());
            }
            if (recognition instanceof Recognition.Complete) {
                return i + 1 == keys.length() ? recognition : broken(keys, i + 2, ExpectedKeys.END);
            }
        }
        return broken(keys, recognizer.missing());
    }

    private static Recognition broken(String keys, int position, ExpectedKeys expected) {
        return new Recognition.Broken(new OrderFault(keys, position, expected, OrderFault.Limit.NONE, false));
    }

    private static Recognition broken(String keys, OrderFault fault) {
        return new Recognition.Broken(new OrderFault(keys, fault.position(), fault.expected(), fault.limit(), false));
    }
}
