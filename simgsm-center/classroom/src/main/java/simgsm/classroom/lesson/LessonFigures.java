package simgsm.classroom.lesson;

import java.util.List;
import java.util.Optional;
import simgsm.dtmf.DtmfKey;
import simgsm.lesson.LessonFunctions;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;

/** The functions of {@code let} in lessons. */
final class LessonFigures implements LessonFunctions {
    private static final int WORD_LENGTH = 8;
    private static final int TELEPHONE_PLAN = 1;
    private static final int CENTIMETRES = 100;

    @Override
    public String apply(String function, List<String> arguments) {
        String first = arguments.isEmpty() ? "" : arguments.get(0);
        return switch (function) {
            case "low" -> Long.toString(Math.round(key(first).rowHertz()));
            case "high" -> Long.toString(Math.round(key(first).columnHertz()));
            case "xor" -> xor(first);
            case "swapped" -> swapped(first);
            case "half-heard" -> Double.toString(ToneLimits.halfHeardDecibels(Long.parseLong(first)));
            case "most-twist" -> Double.toString(ToneLimits.mostTwistDecibels());
            case "shortest" -> Integer.toString(ToneLimits.shortestMillis());
            case "submit" -> submit(first, arguments.get(1));
            case "off" ->
                Long.toString(Math.round(
                        CENTIMETRES * Math.hypot(Double.parseDouble(first), Double.parseDouble(arguments.get(1)))));
            case "side" -> Double.parseDouble(first) > 0 ? "a" : "b";
            case "text" -> String.join(" ", arguments);
            default -> throw new IllegalArgumentException("unknown function " + function);
        };
    }

    private static DtmfKey key(String text) {
        return DtmfKey.sequence(text).get(0);
    }

    /**
     * A SUBMIT without a status report and with the centre's validity: hexadecimal octets separated by blanks, as
     * students type.
     */
    private static String submit(String number, String text) {
        return TpduCodec.encode(new SubmitTpdu(
                        false,
                        false,
                        false,
                        0,
                        new SmsAddress(SmsAddress.UNKNOWN, TELEPHONE_PLAN, number),
                        0,
                        Optional.empty(),
                        UserData.of(text)))
                .toString()
                .replaceAll("..(?=.)", "$0 ");
    }

    /** The exclusive or of the halves of 16 hexadecimal digits: SRES from RES (TS 33.102, conversion function c2). */
    private static String xor(String hex) {
        long left = Long.parseLong(hex.substring(0, WORD_LENGTH), 16);
        long right = Long.parseLong(hex.substring(WORD_LENGTH), 16);
        return String.format("%08x", left ^ right);
    }

    /** Digits as semi-octets, the first in the lower half, padded with f (TS 24.008, 10.5.4.7). */
    private static String swapped(String digits) {
        String even = digits.length() % 2 == 0 ? digits : digits + "f";
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < even.length(); i += 2) {
            text.append(even.charAt(i + 1)).append(even.charAt(i));
        }
        return text.toString();
    }
}
