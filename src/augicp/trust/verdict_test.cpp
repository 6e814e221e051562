// SPDX-License-Identifier: MIT
#include "augicp/trust/verdict.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <tuple>

#include "augicp/trust/free_motions.h"

namespace augicp {
namespace {

// 600 of 1000 points are seen, and nearly all of them agree.
Evidence good_evidence() {
  Evidence evidence;
  evidence.source_in_target = {{.agree = 570, .differ = 25, .conflict = 5, .hidden = 100, .unseen = 300}, true};
  evidence.target_in_source = evidence.source_in_target;
  evidence.last_step = evidence.last_rotation_step = 1e-6;
  return evidence;
}

TEST(Verdict, AgreementBothWaysConverges) {
  const Verdict verdict = decide(AlignStatus::Converged, good_evidence());
  EXPECT_EQ(verdict.status, AlignStatus::Converged);
  EXPECT_TRUE(verdict.doubts.empty());
  EXPECT_LE(strain(good_evidence()), 1.0);
}

TEST(Verdict, EachSideAloneCanRaiseEachDoubt) {
  const Agreement little{.agree = 100, .unseen = 900};
  const Agreement beside{.agree = 560, .differ = 240, .unseen = 200};
  const Agreement seen_through{.agree = 550, .conflict = 50, .unseen = 400};
  const std::pair<Agreement, Doubt> cases[] = {
      {little, Doubt::LittleSeen}, {beside, Doubt::Disagreement}, {seen_through, Doubt::FreeSpace}};
  for (const auto& [count, doubt] : cases)
    for (Testimony Evidence::*side : {&Evidence::source_in_target, &Evidence::target_in_source}) {
      Evidence evidence = good_evidence();
      (evidence.*side).count = count;
      const Verdict verdict = decide(AlignStatus::Converged, evidence);
      EXPECT_EQ(verdict.status, AlignStatus::Doubtful) << name_of(doubt);
      EXPECT_EQ(verdict.doubts, std::vector<Doubt>{doubt}) << name_of(doubt);
      EXPECT_GT(strain(evidence), 1.0) << name_of(doubt);
    }
}

TEST(Verdict, ExcessCountsEachDoubtAndNothingElse) {
  EXPECT_EQ(excess(good_evidence()), 0.0);
  Evidence one = good_evidence();
  one.source_in_target.contradicting = 1.5 * VerdictLimits{}.max_contradicting;
  EXPECT_NEAR(excess(one), 0.5, 1e-12);
  Evidence two = one;
  two.target_in_source.count = {.agree = 550, .conflict = 50, .unseen = 400};
  EXPECT_GT(excess(two), excess(one));
}

// A moving car is in the free space of the other scan: one limit is far exceeded, all else agrees.
TEST(Verdict, APoseWithOneDoubtIsBetterThanOneWithTwoLesserOnes) {
  Evidence car = good_evidence(), wrong = good_evidence();
  car.source_in_target.count = {.agree = 900, .conflict = 72, .unseen = 28};
  wrong.source_in_target.count = {.agree = 750, .differ = 180, .conflict = 70};
  ASSERT_LT(strain(wrong), strain(car));
  EXPECT_LT(excess(car), excess(wrong));
}

// A fragment that is bent contradicts by a fifth of itself; a wrong pose misses two limits by a little more than twice.
TEST(Verdict, OneLimitMissedByFarCountsLessThanTwo) {
  Evidence bent = good_evidence(), wrong = good_evidence();
  bent.source_in_target.contradicting = 12.0 * VerdictLimits{}.max_contradicting;
  EXPECT_NEAR(excess(bent), 2.0, 1e-12);
  wrong.source_in_target.count.conflict = 80;
  wrong.source_in_target.contradicting = 2.5 * VerdictLimits{}.max_contradicting;
  EXPECT_GT(excess(wrong), excess(bent));
}

TEST(Verdict, APartThatContradictsIsADoubtOnEachSide) {
  for (Testimony Evidence::*side : {&Evidence::source_in_target, &Evidence::target_in_source}) {
    Evidence evidence = good_evidence();
    (evidence.*side).contradicting = 0.9 * VerdictLimits{}.max_contradicting;
    EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Converged);
    (evidence.*side).contradicting = 1.1 * VerdictLimits{}.max_contradicting;
    EXPECT_EQ(decide(AlignStatus::Converged, evidence).doubts, std::vector<Doubt>{Doubt::Contradiction});
    EXPECT_FALSE(fits_as_well(evidence, good_evidence()));
  }
}

// An overlap of three tenths is enough if all of it agrees, and too little if a seventh does not.
TEST(Verdict, TheLessIsSeenTheBetterItMustAgree) {
  Evidence evidence = good_evidence();
  evidence.source_in_target.count = {.agree = 300, .unseen = 700};
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Converged);
  evidence.source_in_target.count = {.agree = 258, .differ = 42, .unseen = 700};
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).doubts, std::vector<Doubt>{Doubt::LittleSeen});
  evidence.source_in_target.count = {.agree = 516, .differ = 84, .unseen = 400};
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Converged);
}

// Half of what fits by chance agrees by nine tenths. It is enough only if both know their free space, or one is a part.
TEST(Verdict, WithoutLinesOfSightHalfAnOverlapMustAgreeBetter) {
  const Agreement half{.agree = 450, .differ = 50, .unseen = 500};
  Evidence evidence = good_evidence();
  evidence.source_in_target.count = evidence.target_in_source.count = half;
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Converged);
  for (Testimony Evidence::*side : {&Evidence::source_in_target, &Evidence::target_in_source}) {
    Evidence blind = evidence;
    (blind.*side).knows_free_space = false;
    EXPECT_EQ(decide(AlignStatus::Converged, blind).doubts, std::vector<Doubt>{Doubt::LittleSeen});
    (blind.*side).count = {.agree = 850, .differ = 50, .unseen = 100};
    EXPECT_EQ(decide(AlignStatus::Converged, blind).status, AlignStatus::Converged);
    (blind.*side).count = {.agree = 1000};
    (blind.*side).knows_free_space = false;
    EXPECT_EQ(decide(AlignStatus::Converged, blind).status, AlignStatus::Converged);
  }
}

// A scan of one side on the whole model: the model's back has no partner. What it puts into free space still counts.
TEST(Verdict, APartIsNotAskedForWhatItLacks) {
  for (const bool source_is_part : {false, true}) {
    Evidence evidence = good_evidence();
    Testimony& of_part = source_is_part ? evidence.source_in_target : evidence.target_in_source;
    Testimony& of_model = source_is_part ? evidence.target_in_source : evidence.source_in_target;
    of_part.count = {.agree = 995, .differ = 5};
    of_model.count = {.agree = 200, .differ = 300, .unseen = 500};
    EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Converged);
    of_model.count.conflict = 60;
    EXPECT_EQ(decide(AlignStatus::Converged, evidence).doubts, std::vector<Doubt>{Doubt::FreeSpace});
    of_model.count.conflict = 0;
    of_part.count = {.agree = 985, .differ = 15};
    EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Doubtful);
  }
}

// It disagrees a little with the model in smaller balls, and is compared with no more of it for that.
TEST(Verdict, AKnownPartIsNotAskedEither) {
  Evidence evidence = good_evidence();
  evidence.source_in_target.count = {.agree = 995, .differ = 5};
  evidence.target_in_source.count = {.agree = 200, .differ = 300, .unseen = 500};
  EXPECT_EQ(part_of(evidence), Part::Source);
  evidence.source_in_target.count = {.agree = 950, .differ = 50};
  EXPECT_EQ(part_of(evidence), Part::None);
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Doubtful);
  evidence.known_part = Part::Target;
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Doubtful);
  evidence.known_part = Part::Source;
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Converged);
  Evidence rival = evidence;
  rival.target_in_source.count = {.agree = 100, .differ = 300, .unseen = 600};
  EXPECT_TRUE(fits_as_well(rival, evidence));
  evidence.source_in_target.count = {.agree = 780, .differ = 220};
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Doubtful);
}

// Two scans of one whole show all of each other.
TEST(Verdict, AWholeIsNoPart) {
  Evidence evidence = good_evidence();
  evidence.source_in_target.count = evidence.target_in_source.count = {.agree = 1000};
  EXPECT_EQ(part_of(evidence), Part::None);
}

TEST(Verdict, ARivalFitsAsWellIfItsEvidenceIsAsGood) {
  EXPECT_TRUE(fits_as_well(good_evidence(), good_evidence()));
  Evidence contradicted = good_evidence();
  contradicted.target_in_source.count = {.agree = 550, .conflict = 50, .unseen = 400};
  EXPECT_FALSE(fits_as_well(contradicted, good_evidence()));
  Evidence moving = good_evidence();
  moving.last_step = 1e-2;
  EXPECT_FALSE(fits_as_well(moving, good_evidence()));
  Evidence far = good_evidence();  // rivals are far from the guess by their nature
  far.beyond_planes = 0.0;
  far.moved = 2.0;
  EXPECT_FALSE(strain(far) <= 1.0);
  EXPECT_TRUE(fits_as_well(far, good_evidence()));
}

// Between poses that fit alike the strain differs by chance, on either side of a limit. One that fits clearly worse is
// no rival, though no limit refuses it.
TEST(Verdict, ARivalMustNotBeClearlyWorse) {
  Evidence best = good_evidence(), rival = best;
  best.target_in_source.count = {.agree = 953, .conflict = 47};
  rival.target_in_source.count = {.agree = 945, .conflict = 55};
  EXPECT_GT(strain(best), 0.9);
  EXPECT_GT(strain(rival), 1.0);
  EXPECT_TRUE(fits_as_well(rival, best));
  rival.target_in_source.count = {.agree = 930, .conflict = 70};
  EXPECT_FALSE(fits_as_well(rival, best));
  best.source_in_target.count = best.target_in_source.count = {.agree = 1000};
  rival.target_in_source.count = {.agree = 975, .conflict = 25};
  EXPECT_LT(strain(rival), 1.0);
  EXPECT_FALSE(fits_as_well(rival, best));
}

// A pose that a limit refuses by little may still be the right one, one that it refuses by much is not.
TEST(Verdict, WhatTheGuessLeadsToMayFitThoughALimitRefusesIt) {
  Evidence of_guess = good_evidence();
  of_guess.target_in_source.count = {.agree = 770, .differ = 230};
  EXPECT_FALSE(fits_as_well(of_guess, good_evidence()));
  EXPECT_TRUE(may_fit(of_guess, good_evidence()));
  Evidence moving = of_guess;
  moving.last_step = 1e-2;
  EXPECT_FALSE(fits_as_well(moving, good_evidence()));
  EXPECT_TRUE(may_fit(moving, good_evidence()));
  of_guess.target_in_source.count = {.agree = 680, .differ = 320};
  EXPECT_FALSE(may_fit(of_guess, good_evidence()));
}

// Far from the guess a little in free space refuses a pose. What the guess leads to is not judged as if it were there.
TEST(Verdict, WhatTheGuessLeadsToIsNotJudgedAsAPoseFarFromIt) {
  Evidence of_guess = good_evidence(), far = good_evidence();
  for (Testimony* side : {&of_guess.source_in_target, &of_guess.target_in_source})
    side->count = {.agree = 960, .conflict = 40};
  far.moved = 2.0;
  EXPECT_TRUE(fits_as_well(of_guess, far));
  EXPECT_TRUE(may_fit(of_guess, far));
  of_guess.moved = 2.0;
  EXPECT_FALSE(fits_as_well(of_guess, far));
}

// Near a guess the limit of both sides together is wide. A rival far away must not use it.
TEST(Verdict, ARivalMustNotStandInFreeSpaceWhereTheBestDoesNot) {
  Evidence best = good_evidence(), rival = best;
  best.moved = 0.8;
  rival.moved = 2.0;
  const Agreement in_free_space{.agree = 960, .conflict = 40};
  rival.source_in_target.count = rival.target_in_source.count = in_free_space;
  EXPECT_FALSE(fits_as_well(rival, best));
  rival.moved = 0.8;
  EXPECT_TRUE(fits_as_well(rival, best));
  rival.moved = 2.0;
  best.source_in_target.count = best.target_in_source.count = in_free_space;
  EXPECT_TRUE(fits_as_well(rival, best));
}

// Without free space a contradiction is merely unseen: what leaves more of it unseen is the worse pose.
TEST(Verdict, ARivalMustSeeAsMuchWhereFreeSpaceIsUnknown) {
  Evidence best = good_evidence(), rival = best;
  best.source_in_target.count = {.agree = 900, .unseen = 100};
  rival.source_in_target.count = {.agree = 700, .unseen = 300};
  EXPECT_TRUE(fits_as_well(rival, best));
  rival.source_in_target.knows_free_space = best.source_in_target.knows_free_space = false;
  EXPECT_FALSE(fits_as_well(rival, best));
  rival.source_in_target.count = {.agree = 870, .unseen = 130};
  EXPECT_TRUE(fits_as_well(rival, best));
}

// Two independent sayings about one pose: the weaker the one, the stronger must be the other.
TEST(Verdict, APoseNearItsLimitsMustNotBeOutvoted) {
  Evidence evidence = good_evidence();
  evidence.moved = kMovedFromAnywhere;
  evidence.source_in_target.count = evidence.target_in_source.count = {.agree = 700, .unseen = 300};
  const double otherwise = strain(evidence);
  ASSERT_LT(otherwise, 0.5);
  evidence.outvoted = 0.9 * VerdictLimits{}.max_outvoted / otherwise;
  EXPECT_GT(evidence.outvoted, 1.0);
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Converged);
  EXPECT_NEAR(strain(evidence), 0.9, 1e-9);
  evidence.outvoted = 1.1 * VerdictLimits{}.max_outvoted / otherwise;
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).doubts, std::vector<Doubt>{Doubt::Outvoted});
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Doubtful);
}

TEST(Verdict, NearerToTheGuessOtherPosesCountLess) {
  Evidence evidence = good_evidence();
  evidence.outvoted = 1.5 * VerdictLimits{}.max_outvoted / strain(evidence);
  for (const auto& [moved, is_doubtful] : {std::pair{0.6, false}, {1.2, false}, {1.5, true}, {10.0, true}}) {
    evidence.moved = moved;
    EXPECT_EQ(!decide(AlignStatus::Converged, evidence).doubts.empty(), is_doubtful) << moved;
  }
}

// Three bare planes fit any other three: there the guess must have been near. What else agrees makes up for a far one.
TEST(Verdict, BarePlanesAreTrustedNearTheGuessOnly) {
  Evidence evidence = good_evidence();
  evidence.moved = 2.0;
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Converged);
  evidence.beyond_planes = 0.002;
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).doubts, std::vector<Doubt>{Doubt::BarePlanes});
  EXPECT_GT(strain(evidence), 1.0);
  evidence.moved = 0.1;
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Converged);
}

TEST(Verdict, FartherFromTheGuessMorePointsMustBeOffThePlanes) {
  Evidence evidence = good_evidence();
  evidence.source_in_target.count = evidence.target_in_source.count = {.agree = 700, .unseen = 300};
  for (const auto& [beyond_planes, moved, is_doubtful] : {std::tuple{0.004, 0.5, false},
                                                          {0.004, 1.0, true},
                                                          {0.006, 1.0, false},
                                                          {0.006, kMovedFromAnywhere, true},
                                                          {0.011, kMovedFromAnywhere, false},
                                                          {0.011, 10.0, false}}) {
    evidence.beyond_planes = beyond_planes;
    evidence.moved = moved;
    const auto doubts = decide(AlignStatus::Converged, evidence).doubts;
    EXPECT_EQ(doubts == std::vector<Doubt>{Doubt::BarePlanes}, is_doubtful) << beyond_planes << " " << moved;
  }
}

// The fewer points off the planes agree, the more weighs what stands in free space, unless the guess was near.
TEST(Verdict, BarePlanesWithPointsInFreeSpaceAreTrustedNearTheGuessOnly) {
  Evidence evidence = good_evidence();
  evidence.source_in_target.count = {.agree = 570, .conflict = 25, .hidden = 100, .unseen = 305};  // 4.2 %
  evidence.target_in_source.count = {.agree = 590, .conflict = 5, .hidden = 100, .unseen = 305};   // 0.8 %
  for (const auto& [beyond_planes, moved, status] :
       {std::tuple{0.2, 2.0, AlignStatus::Converged}, std::tuple{0.02, 2.0, AlignStatus::Doubtful},
        std::tuple{0.02, 0.1, AlignStatus::Converged}}) {
    evidence.beyond_planes = beyond_planes;
    evidence.moved = moved;
    EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, status) << beyond_planes << " " << moved;
  }
  evidence.moved = 2.0;
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).doubts, std::vector<Doubt>{Doubt::FreeSpace});
}

// Each ratio is 0.83 to 0.97, alone no doubt. The doubt is that of the larger one.
TEST(Verdict, FarFromTheGuessLittleInViewAndFreeSpaceAddUp) {
  const auto doubts_of = [](const Agreement& count, double moved) {
    Evidence evidence = good_evidence();
    evidence.source_in_target.count = evidence.target_in_source.count = count;
    evidence.moved = moved;
    return decide(AlignStatus::Converged, evidence).doubts;
  };
  const Agreement little{.agree = 300, .unseen = 700}, seen_through{.agree = 973, .conflict = 27};
  const Agreement both{.agree = 292, .conflict = 8, .unseen = 700}, more{.agree = 389, .conflict = 11, .unseen = 600};
  for (const Agreement& count : {little, seen_through}) EXPECT_EQ(doubts_of(count, 2.0), std::vector<Doubt>{});
  EXPECT_EQ(doubts_of(both, 2.0), std::vector<Doubt>{Doubt::LittleSeen});
  EXPECT_EQ(doubts_of(more, 2.0), std::vector<Doubt>{Doubt::FreeSpace});
  for (const Agreement& count : {both, more})
    for (const double moved : {0.1, 1.0}) EXPECT_EQ(doubts_of(count, moved), std::vector<Doubt>{}) << moved;
  EXPECT_EQ(doubts_of({.agree = 930, .conflict = 70}, 0.1), std::vector<Doubt>{Doubt::FreeSpace});  // each side's limit
}

// What one cloud has off its planes, the other may not have seen; a doubt needs both. A part on its model is not asked,
// nor are clouds that know their free space, near the guess.
TEST(Verdict, PlanesThatAgreeFarBetterThanTheRestAreADoubt) {
  Evidence evidence = good_evidence();
  evidence.moved = 2.0;
  const double low = 0.9 * VerdictLimits{}.min_off_planes;
  evidence.source_in_target.off_planes = low;
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Converged);
  evidence.target_in_source.off_planes = low;
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).doubts, std::vector<Doubt>{Doubt::OnlyPlanes});
  EXPECT_GT(strain(evidence), 1.0);
  evidence.moved = 0.1;
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Converged);
  evidence.source_in_target.knows_free_space = false;
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).doubts, std::vector<Doubt>{Doubt::OnlyPlanes});
  evidence.source_in_target.count = {.agree = 1000};
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Converged);
}

TEST(Verdict, WithoutACameraMoreMustAgree) {
  Evidence evidence = good_evidence();
  evidence.source_in_target.count = {.agree = 498, .differ = 102, .unseen = 400};
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Converged);
  evidence.source_in_target.knows_free_space = false;
  EXPECT_EQ(decide(AlignStatus::Converged, evidence).status, AlignStatus::Doubtful);
}

TEST(Verdict, NoWitnessIsADoubt) { EXPECT_EQ(decide(AlignStatus::Converged, {}).status, AlignStatus::Doubtful); }

TEST(Verdict, ALoopThatStoppedConvergedOnlyIfItHadSettled) {
  Evidence evidence = good_evidence();
  EXPECT_EQ(decide(AlignStatus::IterationLimit, evidence).status, AlignStatus::Converged);
  evidence.last_step = 0.01;
  EXPECT_EQ(decide(AlignStatus::IterationLimit, evidence).status, AlignStatus::IterationLimit);
  evidence = good_evidence();
  evidence.last_rotation_step = 0.01;
  EXPECT_EQ(decide(AlignStatus::IterationLimit, evidence).status, AlignStatus::IterationLimit);
  evidence.target_in_source.count = {};
  EXPECT_EQ(decide(AlignStatus::IterationLimit, evidence).status, AlignStatus::Doubtful);
}

// Evidence does not improve a status that is known without it.
TEST(Verdict, OtherStatusesStay) {
  for (const AlignStatus status :
       {AlignStatus::Degenerate, AlignStatus::TooFewPairs, AlignStatus::NoOverlap, AlignStatus::Diverged}) {
    EXPECT_EQ(decide(status, good_evidence()).status, status);
    EXPECT_EQ(decide(status, {}).status, status);
  }
}

TEST(Verdict, SharesAreOfWhatShouldHaveBeenVisible) {
  const Testimony testimony = good_evidence().source_in_target;
  EXPECT_DOUBLE_EQ(testimony.seen(), 0.6);
  EXPECT_DOUBLE_EQ(testimony.agreeing(), 0.95);
  EXPECT_DOUBLE_EQ(testimony.conflicting(), 5.0 / 600.0);
  EXPECT_EQ(Testimony{}.seen(), 0.0);
  EXPECT_EQ(Testimony{}.agreeing(), 0.0);
}

TEST(Verdict, LimitsAreChecked) {
  VerdictLimits limits;
  EXPECT_NO_THROW(limits.check());
  limits.min_agreeing = 1.0;
  EXPECT_THROW(limits.check(), std::invalid_argument);
  limits = {};
  limits.max_conflicting = 0.0;
  EXPECT_THROW(limits.check(), std::invalid_argument);
}

// As in the command's JSON.
TEST(Verdict, DoubtsAndFreeMotionsHaveTheirNames) {
  EXPECT_EQ(name_of(Doubt::LittleSeen), "little_seen");
  EXPECT_EQ(name_of(Doubt::Disagreement), "disagreement");
  EXPECT_EQ(name_of(Doubt::FreeSpace), "free_space");
  EXPECT_EQ(name_of(Doubt::BarePlanes), "bare_planes");
  EXPECT_EQ(name_of(Doubt::OnlyPlanes), "only_planes");
  EXPECT_EQ(name_of(Doubt::Outvoted), "outvoted");
  EXPECT_EQ(name_of(Doubt::LeftGuess), "left_guess");
  EXPECT_EQ(name_of(FreeMotion::Kind::Translation), "translation");
  EXPECT_EQ(name_of(FreeMotion::Kind::Rotation), "rotation");
  EXPECT_EQ(name_of(FreeMotion::Kind::Screw), "screw");
}

}  // namespace
}  // namespace augicp
