package simgsm.center.msc.ss;

import simgsm.air.Msisdn;

/** Receives what phones tell of their users by USSD. */
public interface UserReports {
    /** @param name 1 to 30 characters, no control characters */
    void named(Msisdn number, String name);

    /** A step of a lesson. @param result {@code pass} or {@code fail}; @return false if there is no such step */
    boolean lessonResult(Msisdn number, String lesson, String step, String result, int tries, int hints);
}
