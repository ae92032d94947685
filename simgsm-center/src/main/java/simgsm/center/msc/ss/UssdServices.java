package simgsm.center.msc.ss;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simgsm.air.Msisdn;
import simgsm.lesson.StepResult;
import simgsm.ss.SsError;
import simgsm.ss.UssdText;

/** The services behind USSD codes; any other code fails with the error "unexpected data value". */
final class UssdServices {
    /** The caller's number. */
    private static final String OWN_NUMBER = "*100#";
    /** All services as a menu. */
    private static final String MENU = "*111#";
    /** The status of the robot behind a number. */
    private static final Pattern ROBOT = Pattern.compile("\\*200\\*(\\+?[0-9]{1," + Msisdn.MAX_DIGITS + "})#");
    /** A phone tells its user's name. */
    private static final Pattern NAME = Pattern.compile("\\*300\\*(.*\\S.*)#", Pattern.DOTALL);

    /** The network asks for the name. */
    private static final String NAME_QUESTION = "*300#";
    /** Characters of a name that are kept. */
    private static final int MOST_NAME = 30;

    /** A phone tells a result in a lesson. */
    private static final Pattern RESULT =
            Pattern.compile("\\*301\\*([a-z0-9-]+)\\*([a-z0-9-]+)\\*(pass|fail)\\*([0-9]{1,6})\\*([0-9]{1,6})#");
    /** The question to the robot: the order of the command language that only asks for a report. */
    private static final String REPORT_ORDER = "** #*0 **";

    /** Asks the mobile with a number a question. */
    interface Questions {
        void ask(Msisdn number, String question, Consumer<UssdOutcome> told);
    }

    private final Questions questions;
    private final UserReports reports;
    private final Locale language;
    private final ResourceBundle texts;

    UssdServices(Questions questions, UserReports reports, Locale language) {
        this.questions = questions;
        this.reports = reports;
        this.language = language;
        texts = ResourceBundle.getBundle(
                "simgsm.center.msc.ss.ussd",
                language.getLanguage().equals("es") ? Locale.forLanguageTag("es") : Locale.ROOT,
                UssdServices.class.getModule());
    }

    /** Handles a dialogue begun by a mobile with this code. */
    void begin(UssdSession session, String code) {
        Matcher robot = ROBOT.matcher(code);
        Matcher name = NAME.matcher(code);
        Matcher result = RESULT.matcher(code);
        if (code.equals(OWN_NUMBER)) {
            session.end(session.subscriber().digits());
        } else if (code.equals(MENU)) {
            showMenu(session, "");
        } else if (robot.matches()) {
            reportRobot(session, robot.group(1));
        } else if (name.matches()) {
            noteName(session, name.group(1));
        } else if (code.equals(NAME_QUESTION)) {
            session.ask(text("name"), reply -> noteName(session, reply));
        } else if (result.matches()) {
            noteResult(session, result);
        } else {
            session.fail(SsError.UNEXPECTED_DATA_VALUE);
        }
    }

    private void noteResult(UssdSession session, Matcher code) {
        StepResult told = new StepResult(
                code.group(1),
                code.group(2),
                code.group(3).equals("pass"),
                Integer.parseInt(code.group(4)),
                Integer.parseInt(code.group(5)));
        String key = reports.lessonResult(session.subscriber(), told) ? told.word() : "unknown";
        session.end(text("result." + key, told.lesson(), told.step()));
    }

    private void noteName(UssdSession session, String told) {
        String plain = told.replaceAll("\\p{Cntrl}+", " ").strip();
        String name = plain.codePoints()
                .limit(MOST_NAME)
                .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
                .toString();
        reports.named(session.subscriber(), name);
        session.end(text("named", name));
    }

    private void showMenu(UssdSession session, String before) {
        session.ask(before + text("menu"), choice -> {
            switch (choice.strip()) {
                case "1" -> session.end(text("menu.number", session.subscriber().digits()));
                case "2" -> session.ask(text("menu.robot"), number -> reportRobot(session, number.strip()));
                case "0" -> session.end(text("menu.end"));
                default -> showMenu(session, text("menu.again") + "\n");
            }
        });
    }

    private void reportRobot(UssdSession session, String number) {
        Msisdn asked;
        try {
            asked = Msisdn.parse(number).plain();
        } catch (IllegalArgumentException noNumber) {
            session.end(text("robot.no-number"));
            return;
        }
        questions.ask(asked, REPORT_ORDER, outcome -> session.end(robotText(asked, outcome)));
    }

    private String robotText(Msisdn asked, UssdOutcome outcome) {
        boolean isReply = outcome.kind() == UssdOutcome.Kind.REPLIED && UssdText.fits(outcome.text());
        return isReply ? outcome.text() : text("robot." + outcome.kind(), asked.digits());
    }

    private String text(String key, String... arguments) {
        return new MessageFormat(texts.getString(key), language).format(arguments);
    }
}
